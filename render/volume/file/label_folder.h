#pragma once
/// A folder of masks: TotalSegmentator and others write a volume file for each part of the patient.

#include <filesystem>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_map.h"

namespace pdr {

/// Reads all volume files of `folder` that lie in it directly, in the order of their names, as one label map
/// (label_file.h, joined_labels.h). A mask without a name has that of its file, "liver" of "liver.nii.gz". Those that
/// mark no voxel are no parts, and a note says how many they are. Errors: those of readLabelFile() and of
/// JoinedLabels::add() for the first file that has one, with its name; no volume file; none that marks a voxel;
/// cancelled().
Result<LabelMap> readLabelFolder(const std::filesystem::path& folder, const Progress& progress);

}  // namespace pdr
