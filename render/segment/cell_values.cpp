#include "render/segment/cell_values.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "render/segment/for_each_slice.h"

namespace pdr::segment {
namespace {

/// Calls visit(cell, hu) for each voxel; only one thread at a time visits a cell.
template <typename Visit>
void forEachVoxel(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint, Visit visit) {
    const ivec3 voxels = grid.voxels, block = grid.block;
    const auto visitRow = [&](const std::int16_t* row, std::size_t cell) {
        for (int begin = 0; begin < voxels.x; begin += block.x, ++cell)
            for (int x = begin; x < std::min(begin + block.x, voxels.x); ++x)
                visit(cell, std::max(row[x], Volume::kAirHu));
    };
    forEachSlice(grid.size.z, checkpoint, [&](int k) {
        for (int z = k * block.z; z < std::min((k + 1) * block.z, voxels.z); ++z)
            for (int y = 0; y < voxels.y; ++y)
                visitRow(volume.voxels().data() +
                             (std::size_t(z) * std::size_t(voxels.y) + std::size_t(y)) * std::size_t(voxels.x),
                         grid.index(0, y / block.y, k));
    });
}

/// Calls visit(cell, voxels in it) for each cell.
template <typename Visit>
void forEachCell(const CellGrid& grid, Visit visit) {
    tbb::parallel_for(0, grid.size.z, [&](int k) {
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; ++i)
                visit(grid.index(i, j, k), grid.voxelsIn({i, j, k}));
    });
}

}  // namespace

std::vector<std::int32_t> cellSums(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint) {
    std::vector<std::int32_t> sums(grid.count());
    forEachVoxel(volume, grid, checkpoint, [&](std::size_t cell, std::int16_t hu) { sums[cell] += hu; });
    return sums;
}

Cells cellsAbove(int thresholdHu, const std::vector<std::int32_t>& sums, const CellGrid& grid) {
    Cells cells(sums.size());
    forEachCell(grid,
                [&](std::size_t cell, int voxels) { cells[cell] = sums[cell] > std::int64_t(thresholdHu) * voxels; });
    return cells;
}

CellValues cellValues(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint) {
    std::vector<std::int32_t> sums(grid.count());
    CellValues values{std::vector<std::int16_t>(grid.count()), std::vector<std::int16_t>(grid.count(), Volume::kAirHu)};
    forEachVoxel(volume, grid, checkpoint, [&](std::size_t cell, std::int16_t hu) {
        sums[cell] += hu;
        values.highest[cell] = std::max(values.highest[cell], hu);
    });
    forEachCell(grid, [&](std::size_t cell, int voxels) { values.mean[cell] = std::int16_t(sums[cell] / voxels); });
    return values;
}

}  // namespace pdr::segment
