#pragma once
/// Label maps in volume files: NIfTI, NRRD (also Slicer's .seg.nrrd) and MetaImage with whole numbers from 0 on.

#include <filesystem>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/file/grid_file.h"
#include "render/volume/label_map.h"

namespace pdr {

/// What becomes of a file that marks no voxel.
enum class Unmarked {
    refused,
    taken,  ///< as a map without parts
};

/// Reads the labels of `file` on the grid of the file. The parts are those that have voxels, in the order of their
/// numbers, with the names and colours that the file has for them (label_table.h), or else the standard ones; notes
/// say how many names have no voxels. The file's own name is never that of a part: it may name the patient, and images
/// say the names of parts. Errors: those of readGridFile() and GridSamples; values that are no labels, being fractions
/// or negative; more than 255 labels; none, where `unmarked` says so; not enough memory; cancelled().
Result<LabelMap> readLabelFile(const std::filesystem::path& file, const Progress& progress,
                               const OpenBytes& open = onDisk, Unmarked unmarked = Unmarked::refused);

}  // namespace pdr
