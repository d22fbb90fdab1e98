#include "render/segment/cell_values.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace pdr::segment {

CellValues cellValues(const Volume& volume, const CellGrid& grid) {
    const ivec3 voxels = volume.size(), block = grid.block;
    CellValues values{std::vector<std::int16_t>(grid.count()), std::vector<std::int16_t>(grid.count(), Volume::kAirHu)};
    tbb::parallel_for(0, grid.size.z, [&](int k) {
        std::vector<std::int32_t> sums(grid.sliceCount());
        std::int16_t* highest = &values.highest[grid.index(0, 0, k)];
        const int begin = k * block.z, end = std::min(begin + block.z, voxels.z);
        for (int z = begin; z < end; ++z)
            for (int y = 0; y < voxels.y; ++y) {
                const std::int16_t* row = volume.voxels().data() + (std::size_t(z) * voxels.y + y) * voxels.x;
                const std::size_t first = std::size_t(y / block.y) * std::size_t(grid.size.x);
                for (int x = 0; x < voxels.x; ++x) {
                    const std::size_t cell = first + std::size_t(x / block.x);
                    const std::int16_t hu = std::max(row[x], Volume::kAirHu);
                    sums[cell] += hu;
                    highest[cell] = std::max(highest[cell], hu);
                }
            }
        std::int16_t* mean = &values.mean[grid.index(0, 0, k)];
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; ++i) {
                const int count = (end - begin) * std::min(block.y, voxels.y - j * block.y) *
                                  std::min(block.x, voxels.x - i * block.x);
                const std::size_t cell = std::size_t(j) * std::size_t(grid.size.x) + std::size_t(i);
                mean[cell] = std::int16_t(sums[cell] / count);
            }
    });
    return values;
}

}  // namespace pdr::segment
