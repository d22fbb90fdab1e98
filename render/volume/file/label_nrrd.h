#pragma once
/// Writes label maps for other programs.

#include <filesystem>

#include "render/base/result.h"
#include "render/volume/label_map.h"

namespace pdr {

/// The ending by which 3D Slicer knows a segmentation.
inline constexpr const char* kLabelEnding = ".seg.nrrd";

/// Returns whether the name of `file` ends so, in letters of either case.
bool isLabelFile(const std::filesystem::path& file);

/// Writes `map` as NRRD, packed by gzip, with the names and colours of its parts as 3D Slicer has them. `file` must end
/// in kLabelEnding. Errors: another ending; those of ReplacingFile.
Result<void> writeLabelFile(const LabelMap& map, const std::filesystem::path& file);

}  // namespace pdr
