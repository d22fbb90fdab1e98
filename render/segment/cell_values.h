#pragma once
/// What the voxels of each cell hold; what lies below air counts as air.

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// The sum of each cell's voxels [HU].
std::vector<std::int32_t> cellSums(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint = goOn);
/// The cells whose mean lies above `thresholdHu`.
Cells cellsAbove(int thresholdHu, const std::vector<std::int32_t>& sums, const CellGrid& grid);

struct CellValues {
    std::vector<std::int16_t> mean, highest;  ///< [HU]
};

CellValues cellValues(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
