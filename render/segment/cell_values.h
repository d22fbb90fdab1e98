#pragma once
/// What the voxels of each cell hold.

#include "render/segment/cell_grid.h"

namespace pdr::segment {

struct CellValues {
    std::vector<std::int16_t> mean, highest;  ///< HU; what lies below air counts as air
};

CellValues cellValues(const Volume& volume, const CellGrid& grid);

}  // namespace pdr::segment
