#pragma once
/// Finds the cells that are lung: air inside the body, in pieces of at least 150 ml, most of which is no pure gas as in
/// bowel.

#include "render/segment/body_mask.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Returns the cells of the lungs without their vessels. None where there is no such piece.
Cells lungCells(const Volume& volume, const BodyMask& body, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
