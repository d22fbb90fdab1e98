#pragma once
/// The outline of what a mask holds.

#include "render/segment/cell_grid.h"

namespace pdr::segment {

/// `mask` with what it encloses in a slice (constant k), such as lungs: all cells from which no way through cells that
/// share an edge leads to the border of the slice.
Cells withHolesFilled(const Cells& mask, const CellGrid& grid);

/// `mask` with all cells that touch it, at a corner too.
Cells grown(const Cells& mask, const CellGrid& grid);

/// The part of the grid's cells that a mask lies in: [first, end) along each axis; nothing where first is not below
/// end.
struct CellBox {
    ivec3 first{0}, end{0};
};
CellBox boxOf(const Cells& mask, const CellGrid& grid);

/// Where the rows (along i) of a mask begin and end, in index coordinates of voxels: its convex hull is theirs, but for
/// half a cell.
std::vector<dvec3> rowEnds(const Cells& mask, const CellGrid& grid);

}  // namespace pdr::segment
