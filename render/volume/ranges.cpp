#include "render/volume/ranges.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace pdr {

namespace {

/// Voxels whose values interpolation can meet along one axis inside cell `c`: [first, last]; empty if first > last.
struct Span {
    int first, last;
};

Span voxelsOfCell(int c, int size) {
    const int begin = kFineCell * (c - 1);
    if (begin >= size)
        return {1, 0};
    return {std::max(begin, 0), std::clamp(begin + kFineCell, 0, size - 1)};
}

HuRange rangeOf(const Volume& volume, Span x, Span y, Span z) {
    HuRange range = CellRanges::kEmpty;
    const ivec3 size = volume.size();
    for (int k = z.first; k <= z.last; ++k)
        for (int j = y.first; j <= y.last; ++j) {
            const std::int16_t* row = volume.voxels().data() + (std::size_t(k) * size.y + j) * size.x;
            for (int i = x.first; i <= x.last; ++i) {
                range.lowest = std::min(range.lowest, row[i]);
                range.highest = std::max(range.highest, row[i]);
            }
        }
    return range;
}

int coarseCells(int voxels) {
    // The last point of the volume lies at index coordinate voxels - 0.5, in fine cell (voxels - 1) / 4 + 1.
    const int fine = (voxels - 1) / kFineCell + 2;
    return (fine + kFinePerCoarse - 1) / kFinePerCoarse;
}

}  // namespace

CellRanges::CellRanges(const Volume& volume)
    : coarseSize_(coarseCells(volume.size().x), coarseCells(volume.size().y), coarseCells(volume.size().z)) {
    const ivec3 fine = fineSize();
    cells_.resize(std::size_t(fine.x) * fine.y * fine.z);
    tbb::parallel_for(0, fine.z, [&](int k) {
        for (int j = 0; j < fine.y; ++j)
            for (int i = 0; i < fine.x; ++i)
                cells_[(std::size_t(k) * fine.y + j) * fine.x + i] =
                    rangeOf(volume, voxelsOfCell(i, volume.size().x), voxelsOfCell(j, volume.size().y),
                            voxelsOfCell(k, volume.size().z));
    });
    for (const HuRange& cell : cells_) {
        whole_.lowest = std::min(whole_.lowest, cell.lowest);
        whole_.highest = std::max(whole_.highest, cell.highest);
    }
}

}  // namespace pdr
