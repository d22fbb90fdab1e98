#include "render/segment/cell_values.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "render/segment/for_each_slice.h"

namespace pdr::segment {
namespace {

const std::int16_t* rowOf(const Volume& volume, int y, int z) {
    const ivec3 size = volume.size();
    return volume.voxels().data() + (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
}

/// Adds the values of a row of voxels to `sums`; what is thinner than air counts as air.
void addRow(const std::int16_t* row, std::vector<std::int32_t>& sums) {
    for (std::size_t x = 0; x < sums.size(); ++x)
        sums[x] += std::max(row[x], Volume::kAirHu);
}

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
                visitRow(rowOf(volume, y, z), grid.index(0, y / block.y, k));
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

/// Adds up whole rows first, since that becomes vector instructions.
std::vector<std::int32_t> cellSums(const Volume& volume, const CellGrid& grid, const Checkpoint& checkpoint) {
    std::vector<std::int32_t> sums(grid.count());
    const ivec3 voxels = grid.voxels, block = grid.block;
    forEachSlice(grid.size.z, checkpoint, [&](int k) {
        std::vector<std::int32_t> row(std::size_t(voxels.x));
        for (int j = 0; j < grid.size.y; ++j) {
            std::ranges::fill(row, 0);
            for (int z = k * block.z; z < std::min((k + 1) * block.z, voxels.z); ++z)
                for (int y = j * block.y; y < std::min((j + 1) * block.y, voxels.y); ++y)
                    addRow(rowOf(volume, y, z), row);
            for (int i = 0; i < grid.size.x; ++i)
                sums[grid.index(i, j, k)] =
                    std::accumulate(row.begin() + i * block.x, row.begin() + std::min((i + 1) * block.x, voxels.x), 0);
        }
    });
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
