#include "render/segment/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "render/volume/sheared.h"

namespace pdr::segment {
namespace {

constexpr double kCellMm = 2;

}  // namespace

CellGrid CellGrid::over(const VolumeGeometry& geometry) {
    CellGrid grid;
    grid.voxels = geometry.size;
    const dvec3 spacing = statedSpacingMm(geometry);
    for (int axis = 0; axis < 3; ++axis) {
        const double wanted = std::min(kCellMm / spacing[axis], double(geometry.size[axis]));
        grid.block[axis] = std::max(1, int(std::lround(wanted)));
        grid.size[axis] = (geometry.size[axis] + grid.block[axis] - 1) / grid.block[axis];
        grid.spacingMm[axis] = spacing[axis] * grid.block[axis];
    }
    grid.driftMm = sliceDrift(geometry).sidewaysMm * double(grid.block.z);
    return grid;
}

double volumeMl(const Cells& cells, const CellGrid& grid) {
    std::int64_t count = 0;
    std::size_t i = 0;
    for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x, ++i)
                if (cells[i])
                    count += grid.voxelsIn({x, y, z});
    return double(count) * grid.cellMl() / (double(grid.block.x) * grid.block.y * grid.block.z);
}

}  // namespace pdr::segment
