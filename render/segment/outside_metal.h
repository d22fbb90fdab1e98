#pragma once
/// Metal outside the body: a stereotactic frame, an instrument or a screw of the table. Which, nobody can know here, so
/// it stays, and with it all that it touches.

#include "render/segment/body_mask.h"

namespace pdr::segment {

/// Shows, of what `mask` of `volume` hides, the cells that hold a voxel above kMetalHu, and the solids that hang
/// together with those or are no more than a cell away. The box and the rows' ends of `mask` hold them then, and what
/// of them touched the body counts as cut no more; the body stays as it is. Never hides anything. Returns what it shows
/// [ml].
double showMetal(const Volume& volume, BodyMask& mask);

}  // namespace pdr::segment
