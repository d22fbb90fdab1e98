#pragma once
/// Bone that one side of a patient has and the other lacks: what closes a defect of the skull.
///   1. the plane of symmetry is found by the bones (symmetry.h); if half of their mirrored surface lies more than 3 mm
///      from their surface, there is none
///   2. what lacks bone is mirrored bone more than 6 mm from the bones, in pieces of at least 1 ml; sides differ by
///   less
///   3. it extends to all mirrored bone within 8 mm of such a piece that is no bone, which is where the bones begin
/// Both sides are searched. A defect that crosses the plane is closed only as far as the other side has bone.

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_map.h"
#include "render/volume/volume.h"

namespace pdr::segment {

/// Returns a label map of `volume` with one part, "mirrored bone", of voxels below 250 HU whose mirror images are above
/// it, and a note on how well the sides fit. The same for any number of threads. Errors, of kind refused: those of
/// bodyMask(), no bones, sides that do not fit, nothing that is lacking; else cancelled(), and not enough memory.
Result<LabelMap> findMirroredBone(const Volume& volume, const Progress& progress);

}  // namespace pdr::segment
