#pragma once
/// Finds pools of blood with contrast medium: it is uniform, and bone is not.

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Returns the cells of blood in pools of at least 5 ml: those whose 27 neighbours, 6 mm across, have means from
/// `leastHu` to 1200 HU that differ by no more than noise. `mean`: that of each cell [HU]. A pool's rim, where its
/// neighbours are no blood, is left out.
Cells bloodPools(const std::vector<std::int16_t>& mean, const CellGrid& grid, int leastHu,
                 const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
