#pragma once
/// How far places lie from the surface of a set of cells, smooth between and across cells: what the edge of a mask is
/// made of. The steps of the cells are smoothed away, over about two cells; on even surfaces nothing is moved by that.

#include <vector>

#include "render/segment/cell_grid.h"

namespace pdr::segment {

class SmoothDistance {
  public:
    /// From the surface of the cells whose flag is `value`, on their outside, known up to `reachMm`: beyond, and where
    /// there are no such cells, it is `reachMm`. Up to half a cell off where cells are not cubes.
    SmoothDistance(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm);

    /// At a place of the volume (index space of its voxels) [mm]; negative by up to half a cell's edge in the cells
    /// themselves.
    double at(dvec3 place) const;

  private:
    void smooth();

    CellGrid grid_;
    std::vector<float> mm_;
};

}  // namespace pdr::segment
