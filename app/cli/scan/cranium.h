#pragma once
/// The head CT with a cranial defect that comes with InVesalius (Cranium.inv3), read from its raw voxels.

#include <filesystem>

#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::app {

/// Reads `matrixFile`, which is matrix.dat: int16 little-endian, 256 x 256 x 108 voxels, x fastest, the rows of a slice
/// from the back to the front. Reverses the rows (y to the back), so that nothing is mirrored. The volume has voxels of
/// 0.9570312 x 0.9570312 x 1.5 mm in patient space LPS and is centred on the origin. Errors: the file is missing or has
/// another size.
Result<Volume> readCranium(const std::filesystem::path& matrixFile);

}  // namespace pdr::app
