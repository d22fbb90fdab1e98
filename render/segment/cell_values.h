#pragma once
/// Statistics of the voxels of each cell; values below air count as air.

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Returns the sum of each cell's voxels [HU].
std::vector<std::int32_t> cellSums(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint = goOn);
/// Returns the cells whose mean lies above `thresholdHu`.
Cells cellsAbove(int thresholdHu, const std::vector<std::int32_t>& sums, const CellGrid& grid);

struct CellValues {
    std::vector<std::int16_t> mean, highest;  ///< [HU]
};

CellValues cellValues(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
