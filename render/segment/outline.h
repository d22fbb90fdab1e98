#pragma once
/// Outlines of masks of cells.

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Returns `mask` with what it encloses in a slice (constant k), such as lungs: all cells from which no path through
/// cells that share an edge leads to the border of the slice.
Cells withHolesFilled(const Cells& mask, const CellGrid& grid, const Checkpoint& checkpoint = goOn);

/// Returns `mask` with all cells that touch it, also at a corner.
Cells grown(const Cells& mask, const CellGrid& grid, const Checkpoint& checkpoint = goOn);

/// The part of the grid in which the cells of a mask lie: [first, end) along each axis; empty where first is not below
/// end.
struct CellBox {
    ivec3 first{0}, end{0};
};
CellBox boxOf(const Cells& mask, const CellGrid& grid);

/// Returns the ends of the rows (along i) of a mask, in index coordinates of voxels: the convex hull of these points
/// is that of the mask, but for half a cell.
std::vector<dvec3> rowEnds(const Cells& mask, const CellGrid& grid);

}  // namespace pdr::segment
