#pragma once
/// Distances of points from the surface of a set of cells, smooth between and across cells: the edge of a mask is made
/// from them. The steps of the cells are smoothed away, over about two cells; flat surfaces do not move.

#include <algorithm>
#include <vector>

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

class SmoothDistance {
  public:
    /// Computes distances from the surface of the cells whose flag is `value`, on their outside, known up to `reachMm`:
    /// beyond, and where there are no such cells, the distance is `reachMm`. Up to half a cell off where cells are not
    /// cubes.
    SmoothDistance(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
                   const Checkpoint& checkpoint = goOn);

    /// Returns the distance at a place of the volume (index space of its voxels) [mm]; negative by up to half a cell's
    /// edge in the cells themselves.
    double at(dvec3 place) const;
    /// Writes at() of `count` places, `step` voxels apart along x from `first` on, into mm[0 .. count).
    void along(ivec3 first, int step, int count, double* mm) const;

  private:
    /// Two neighbouring cells along an axis, and the fraction f of the way from one centre to the other, [0, 1].
    struct Between {
        int low, high;
        double f;
    };
    Between between(double place, int axis) const {
        const double cell = (place + 0.5) / double(grid_.block[axis]) - 0.5;  // in cells, 0 at the first centre
        const double inside = std::clamp(cell, 0.0, double(grid_.size[axis] - 1));
        const int low = std::min(int(inside), std::max(grid_.size[axis] - 2, 0));
        return {low, std::min(low + 1, grid_.size[axis] - 1), inside - double(low)};
    }
    void smooth(const Checkpoint& checkpoint);

    CellGrid grid_;
    std::vector<float> mm_;
};

}  // namespace pdr::segment
