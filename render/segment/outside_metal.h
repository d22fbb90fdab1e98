#pragma once
/// Metal outside the body: a stereotactic frame, an instrument or a screw of the table. These cannot be told apart
/// here, so the metal stays, and with it all that it touches.

#include "render/segment/body_mask.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Shows, of what `mask` of `volume` hides, the cells that hold a voxel above kMetalHu, and the solids that are
/// connected with those or no more than a cell away. The box and the rows' ends of `mask` then include them, and
/// what of them touched the body no longer counts as cut; the body stays as it is. Never hides anything. Returns the
/// volume that it shows [ml].
double showMetal(const Volume& volume, BodyMask& mask, const Checkpoint& checkpoint);

}  // namespace pdr::segment
