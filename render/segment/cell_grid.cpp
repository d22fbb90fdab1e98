#include "render/segment/cell_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pdr::segment {
namespace {

constexpr double kCellMm = 2;

/// Adds up each `block` of the `length` values of `row`; what lies below air counts as air.
void addRow(const std::int16_t* row, int length, int block, std::int32_t* sums) {
    for (int begin = 0; begin < length; begin += block, ++sums)
        for (int x = begin; x < std::min(begin + block, length); ++x)
            *sums += std::max(row[x], Volume::kAirHu);
}

}  // namespace

CellGrid CellGrid::over(const VolumeGeometry& geometry) {
    CellGrid grid;
    const dvec3 spacing = geometry.spacingMm();
    for (int axis = 0; axis < 3; ++axis) {
        const double wanted = std::min(kCellMm / spacing[axis], double(geometry.size[axis]));
        grid.block[axis] = std::max(1, int(std::lround(wanted)));
        grid.size[axis] = (geometry.size[axis] + grid.block[axis] - 1) / grid.block[axis];
        grid.spacingMm[axis] = spacing[axis] * grid.block[axis];
    }
    return grid;
}

Cells cellsAbove(int thresholdHu, const Volume& volume, const CellGrid& grid) {
    const ivec3 voxels = volume.size(), block = grid.block;
    Cells cells(grid.count());
    tbb::parallel_for(0, grid.size.z, [&](int k) {
        std::vector<std::int32_t> sums(std::size_t(grid.size.x));
        const int zBegin = k * block.z, zEnd = std::min(zBegin + block.z, voxels.z);
        for (int j = 0; j < grid.size.y; ++j) {
            const int yBegin = j * block.y, yEnd = std::min(yBegin + block.y, voxels.y);
            std::fill(sums.begin(), sums.end(), 0);
            for (int z = zBegin; z < zEnd; ++z)
                for (int y = yBegin; y < yEnd; ++y)
                    addRow(volume.voxels().data() + (std::size_t(z) * voxels.y + y) * voxels.x, voxels.x, block.x,
                           sums.data());
            const int rows = (zEnd - zBegin) * (yEnd - yBegin);
            std::uint8_t* cell = &cells[grid.index(0, j, k)];
            for (int i = 0; i < grid.size.x; ++i) {
                const int width = std::min(block.x, voxels.x - i * block.x);
                cell[i] = sums[std::size_t(i)] > std::int64_t(thresholdHu) * rows * width;
            }
        }
    });
    return cells;
}

double volumeMl(const Cells& cells, const CellGrid& grid, ivec3 voxels) {
    std::int64_t count = 0;
    std::size_t i = 0;
    for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x, ++i)
                if (cells[i]) {
                    const ivec3 edges = glm::min(grid.block, voxels - ivec3(x, y, z) * grid.block);
                    count += std::int64_t(edges.x) * edges.y * edges.z;
                }
    return double(count) * grid.cellMl() / (double(grid.block.x) * grid.block.y * grid.block.z);
}

}  // namespace pdr::segment
