#pragma once
/// The head CT with a cranial defect that comes with InVesalius (Cranium.inv3), read from its raw voxels.

#include <filesystem>

#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::app {

/// `matrixFile` is matrix.dat: int16 little-endian, 256 x 256 x 108, x fastest, rows of a slice from the back to the
/// front. The volume has its rows turned round (y to the back), so that nothing is mirrored: patient space LPS, voxels
/// of 0.9570312 x 0.9570312 x 1.5 mm, centred on the origin. Errors: no such file, another size.
Result<Volume> readCranium(const std::filesystem::path& matrixFile);

}  // namespace pdr::app
