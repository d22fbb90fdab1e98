#include "render/segment/cell_grid.h"

#include <algorithm>
#include <cmath>

namespace pdr::segment {
namespace {

constexpr double kCellMm = 2;

}  // namespace

CellGrid CellGrid::over(const VolumeGeometry& geometry) {
    CellGrid grid;
    grid.voxels = geometry.size;
    const dvec3 spacing = geometry.spacingMm();
    for (int axis = 0; axis < 3; ++axis) {
        const double wanted = std::min(kCellMm / spacing[axis], double(geometry.size[axis]));
        grid.block[axis] = std::max(1, int(std::lround(wanted)));
        grid.size[axis] = (geometry.size[axis] + grid.block[axis] - 1) / grid.block[axis];
        grid.spacingMm[axis] = spacing[axis] * grid.block[axis];
    }
    return grid;
}

}  // namespace pdr::segment
