#include "render/volume/ranges.h"

#include <tbb/parallel_for.h>

namespace pdr {

CellRanges::CellRanges(const Volume& volume) : coarseSize_(coarseCells(volume.size())) {
    const ivec3 fine = fineSize();
    cells_.resize(std::size_t(fine.x) * fine.y * fine.z);
    tbb::parallel_for(0, fine.z, [&](int k) {
        for (int j = 0; j < fine.y; ++j)
            for (int i = 0; i < fine.x; ++i)
                cells_[cellIndex({i, j, k}, fine)] = rangeOfCell(volume.voxels().data(), volume.size(), {i, j, k});
    });
    for (const HuRange& cell : cells_)
        whole_.include(cell);
}

}  // namespace pdr
