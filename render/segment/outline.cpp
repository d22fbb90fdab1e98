#include "render/segment/outline.h"

#include <algorithm>
#include <iterator>

#include "render/segment/for_each_slice.h"

namespace pdr::segment {
namespace {

/// A flood fill from the border inwards through one slice.
class Flood {
  public:
    Flood(const std::uint8_t* mask, ivec2 size, std::uint8_t* filled) : mask_(mask), size_(size), filled_(filled) {}

    /// Sets `filled` to 0 where the flood arrives, 1 elsewhere.
    void run() {
        std::fill_n(filled_, std::size_t(size_.x) * std::size_t(size_.y), std::uint8_t(1));
        for (int x = 0; x < size_.x; ++x) {
            reach(x, 0);
            reach(x, size_.y - 1);
        }
        for (int y = 0; y < size_.y; ++y) {
            reach(0, y);
            reach(size_.x - 1, y);
        }
        while (!waiting_.empty()) {
            const ivec2 at = waiting_.back();
            waiting_.pop_back();
            reach(at.x - 1, at.y);
            reach(at.x + 1, at.y);
            reach(at.x, at.y - 1);
            reach(at.x, at.y + 1);
        }
    }

  private:
    void reach(int x, int y) {
        if (x < 0 || y < 0 || x >= size_.x || y >= size_.y)
            return;
        const std::size_t i = std::size_t(y) * std::size_t(size_.x) + std::size_t(x);
        if (mask_[i] || !filled_[i])
            return;
        filled_[i] = 0;
        waiting_.emplace_back(x, y);
    }

    const std::uint8_t* mask_;
    ivec2 size_;
    std::uint8_t* filled_;
    std::vector<ivec2> waiting_;
};

/// Computes to[i] |= from[i].
void join(std::uint8_t* to, const std::uint8_t* from, int count) {
    for (int i = 0; i < count; ++i)
        to[i] |= from[i];
}

}  // namespace

Cells withHolesFilled(const Cells& mask, const CellGrid& grid, const Checkpoint& checkpoint) {
    Cells filled(mask.size());
    forEachSlice(grid.size.z, checkpoint, [&](int z) {
        const std::size_t first = grid.index(0, 0, z);
        Flood(&mask[first], ivec2(grid.size), &filled[first]).run();
    });
    return filled;
}

Cells grown(const Cells& mask, const CellGrid& grid, const Checkpoint& checkpoint) {
    Cells inRows = mask, result(mask.size());
    const ivec3 size = grid.size;
    forEachSlice(size.z, checkpoint, [&](int z) {
        for (int y = 0; y < size.y; ++y) {
            const std::uint8_t* from = &mask[grid.index(0, y, z)];
            std::uint8_t* to = &inRows[grid.index(0, y, z)];
            join(to + 1, from, size.x - 1);
            join(to, from + 1, size.x - 1);
        }
    });
    forEachSlice(size.z, checkpoint, [&](int z) {
        for (int y = 0; y < size.y; ++y)
            for (int k = std::max(0, z - 1); k <= std::min(size.z - 1, z + 1); ++k)
                for (int j = std::max(0, y - 1); j <= std::min(size.y - 1, y + 1); ++j)
                    join(&result[grid.index(0, y, z)], &inRows[grid.index(0, j, k)], size.x);
    });
    return result;
}

CellBox boxOf(const Cells& mask, const CellGrid& grid) {
    CellBox box{grid.size, ivec3(0)};
    std::size_t i = 0;
    for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x, ++i)
                if (mask[i]) {
                    box.first = glm::min(box.first, ivec3(x, y, z));
                    box.end = glm::max(box.end, ivec3(x, y, z) + 1);
                }
    return box;
}

std::vector<dvec3> rowEnds(const Cells& mask, const CellGrid& grid) {
    std::vector<dvec3> ends;
    for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y) {
            const auto row = mask.begin() + std::ptrdiff_t(grid.index(0, y, z)), end = row + grid.size.x;
            const auto first = std::find(row, end, 1);
            if (first == end)
                continue;
            const auto last = std::find(std::make_reverse_iterator(end), std::make_reverse_iterator(first), 1);
            for (const std::ptrdiff_t x : {first - row, last.base() - row})
                ends.push_back(dvec3(double(x), y + 0.5, z + 0.5) * dvec3(grid.block) - 0.5);
        }
    return ends;
}

}  // namespace pdr::segment
