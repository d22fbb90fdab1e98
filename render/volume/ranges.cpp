#include "render/volume/ranges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pdr {
namespace {

/// The ranges that the voxels of a row of fine cells have at each place along the row; see rangeOfCell(). Taking whole
/// rows becomes vector instructions.
class RowRanges {
  public:
    explicit RowRanges(const Volume& volume)
        : voxels_(volume.voxels().data()), size_(volume.size()), lowest_(std::size_t(size_.x)), highest_(lowest_) {}

    /// Takes the cells (i, j, k) of any i.
    void take(int j, int k) {
        std::ranges::fill(lowest_, kEmptyRange.lowest);
        std::ranges::fill(highest_, kEmptyRange.highest);
        const VoxelSpan rows = voxelsOfCell(j, size_.y), slices = voxelsOfCell(k, size_.z);
        for (int z = slices.first; z <= slices.last; ++z)
            for (int y = rows.first; y <= rows.last; ++y)
                include(voxels_ + (std::int64_t(z) * size_.y + y) * size_.x);
    }

    HuRange ofCell(int i) const {
        HuRange range = kEmptyRange;
        const VoxelSpan along = voxelsOfCell(i, size_.x);
        for (auto x = std::size_t(along.first); x <= std::size_t(along.last); ++x)
            range.include({lowest_[x], highest_[x]});
        return range;
    }

  private:
    void include(const std::int16_t* row) {
        for (std::size_t x = 0; x < lowest_.size(); ++x) {
            lowest_[x] = std::min(lowest_[x], row[x]);
            highest_[x] = std::max(highest_[x], row[x]);
        }
    }

    const std::int16_t* voxels_;
    ivec3 size_;
    std::vector<std::int16_t> lowest_, highest_;
};

}  // namespace

CellRanges::CellRanges(const Volume& volume) : coarseSize_(coarseCells(volume.size())) {
    const ivec3 fine = fineSize();
    cells_.resize(std::size_t(fine.x) * fine.y * fine.z);
    tbb::parallel_for(0, fine.z, [&](int k) {
        RowRanges row(volume);
        for (int j = 0; j < fine.y; ++j) {
            row.take(j, k);
            for (int i = 0; i < fine.x; ++i)
                cells_[cellIndex({i, j, k}, fine)] = row.ofCell(i);
        }
    });
    for (const HuRange& cell : cells_)
        whole_.include(cell);
}

}  // namespace pdr
