#pragma once
/// The scene of a plan, for `pdrender-cli plan --render`: what the window shows of it.

#include <filesystem>

#include "app/cli/scan/scanned_volume.h"
#include "app/cli/scene/scene_input.h"
#include "app/plan/plan.h"

namespace pdr::app {

/// Returns the scene of `plan`, which was made on the scan `scanned`, on a film of that size [pixels]. Parts that rules
/// find are found again. `labels`: the label map that the plan shows, a file or a folder of masks; empty: none is at
/// hand. Errors: the scan lacks the part that the plan shows, or cannot be denoised; the plan shows another label map,
/// or none; those of reading and finding parts; cancelled().
Result<LoadedScene> sceneOfPlan(const Plan& plan, const ScannedVolume& scanned, const std::filesystem::path& labels,
                                ivec2 film, const Progress& progress);

/// Returns the voxels that the plan shows: with the table or without it.
const std::shared_ptr<const Volume>& volumeOf(const Plan& plan, const ScannedVolume& scanned);

}  // namespace pdr::app
