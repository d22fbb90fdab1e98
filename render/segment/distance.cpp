#include "render/segment/distance.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/segment/for_each_slice.h"

namespace pdr::segment {
namespace {

/// Sets to[i] = min(to[i], from[i] + offset); the arrays do not overlap.
void lower(float* __restrict to, const float* __restrict from, int count, float offset) {
    for (int i = 0; i < count; ++i) {
        const float other = from[i] + offset;
        to[i] = other < to[i] ? other : to[i];
    }
}

/// Computes squared distances along a row.
void alongRow(const std::uint8_t* row, std::uint8_t value, int length, float spacing, float* out) {
    int steps = -1;  // cells since the last one that had the value; -1: none yet
    for (int x = 0; x < length; ++x) {
        steps = row[x] == value ? 0 : steps < 0 ? -1 : steps + 1;
        out[x] = steps < 0 ? kFar : float(steps) * float(steps) * (spacing * spacing);
    }
    steps = -1;
    for (int x = length - 1; x >= 0; --x) {
        steps = row[x] == value ? 0 : steps < 0 ? -1 : steps + 1;
        if (steps >= 0)
            out[x] = std::min(out[x], float(steps) * float(steps) * (spacing * spacing));
    }
}

/// Spreads distances across the rows of a plane: each row gets the minimum over all rows within reach of their values
/// plus the squared distance between the rows.
class RowsApart {
  public:
    RowsApart(int length, int count, double spacingMm, double reachMm)
        : length_(length),
          count_(count),
          reach_(std::min(int(std::ceil(reachMm / spacingMm)), count - 1)),
          squaredStep_(float(spacingMm) * float(spacingMm)) {}

    /// Updates `rows`, which begin `stride` numbers apart. `before`: space for a copy.
    void spread(float* rows, std::size_t stride, std::vector<float>& before) const {
        const std::size_t bytes = std::size_t(length_) * sizeof(float);
        before.resize(std::size_t(length_) * std::size_t(count_));
        for (int y = 0; y < count_; ++y)
            std::memcpy(&before[std::size_t(y) * length_], rows + std::size_t(y) * stride, bytes);
        for (int y = 0; y < count_; ++y)
            for (int other = std::max(0, y - reach_); other <= std::min(count_ - 1, y + reach_); ++other) {
                const float steps = float(other - y);
                if (other != y)
                    lower(rows + std::size_t(y) * stride, &before[std::size_t(other) * length_], length_,
                          steps * steps * squaredStep_);
            }
    }

  private:
    int length_, count_, reach_;
    float squaredStep_;
};

}  // namespace

/// Processes one axis after the other, as Felzenszwalb and Huttenlocher (2012) do, but only up to `reachMm`: there,
/// visiting all neighbours within reach, whole rows at a time, is faster than their lower envelope.
std::vector<float> squaredDistances(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
                                    const Checkpoint& checkpoint) {
    std::vector<float> distances(grid.count());
    tbb::enumerable_thread_specific<std::vector<float>> room;
    const RowsApart alongY(grid.size.x, grid.size.y, grid.spacingMm.y, reachMm);
    forEachSlice(grid.size.z, checkpoint, [&](int z) {
        for (int y = 0; y < grid.size.y; ++y)
            alongRow(&cells[grid.index(0, y, z)], value, grid.size.x, float(grid.spacingMm.x),
                     &distances[grid.index(0, y, z)]);
        alongY.spread(&distances[grid.index(0, 0, z)], std::size_t(grid.size.x), room.local());
    });
    const RowsApart alongZ(grid.size.x, grid.size.z, grid.spacingMm.z, reachMm);
    forEachSlice(grid.size.y, checkpoint,
                 [&](int y) { alongZ.spread(&distances[grid.index(0, y, 0)], grid.sliceCount(), room.local()); });
    return distances;
}

Cells widened(const Cells& cells, const CellGrid& grid, double radiusMm, const Checkpoint& checkpoint) {
    const std::vector<float> distances = squaredDistances(cells, 1, grid, radiusMm, checkpoint);
    Cells wide(cells.size());
    for (std::size_t i = 0; i < wide.size(); ++i)
        wide[i] = atMost(distances[i], radiusMm);
    return wide;
}

}  // namespace pdr::segment
