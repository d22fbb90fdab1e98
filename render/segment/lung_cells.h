#pragma once
/// Which cells are lung: air inside the body, in pieces of at least 150 ml, of which most is no pure gas as in bowel.

#include "render/segment/body_mask.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Without the vessels in it. None where there is no such piece.
Cells lungCells(const Volume& volume, const BodyMask& body, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
