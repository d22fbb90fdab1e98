#pragma once
/// Finds the cells that are bone. Blood with contrast medium may have the HU of marrow, and undiluted in a vein
/// those of cortex, but it is uniform, and bone is not:
///   1. blood is what is uniform over 6 mm, above 300 HU, in pools of at least 5 ml, and what is above 200 HU within 4
///      mm of those
///   2. bone begins where a voxel is above 600 HU, in pieces of at least 0.3 ml: less is chalk in a vessel's wall
///   3. bone extends to what is above 150 HU, is no blood and is connected to it within 12 mm; gaps of 8 mm are closed

#include "render/segment/cell_grid.h"
#include "render/segment/cell_values.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Returns the cells of bone; none where nothing is as dense as bone.
Cells boneCells(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint = goOn);
/// Returns the same, where the cells' values are known.
Cells boneCells(const CellValues& values, const CellGrid& grid, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
