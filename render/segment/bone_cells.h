#pragma once
/// Which cells are bone; see body_parts.h.

#include "render/segment/cell_grid.h"

namespace pdr::segment {

/// None where nothing is as dense as bone.
Cells boneCells(const Volume& volume, const CellGrid& grid);

/// `cells` with all gaps that a ball of `radiusMm` does not fit into.
Cells closed(const Cells& cells, const CellGrid& grid, double radiusMm);

}  // namespace pdr::segment
