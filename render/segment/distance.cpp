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

/// Returns the squared distances within each layer of cells (along i and j).
std::vector<float> withinLayers(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
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
    return distances;
}

/// The layers of a sheared grid, with so much room around them that each is known where others lie above it.
class DriftingLayers {
  public:
    DriftingLayers(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
                   const Checkpoint& checkpoint)
        : grid_(grid), wide_(grid), reach_(std::min(int(std::ceil(reachMm / grid.spacingMm.z)), grid.size.z - 1)) {
        margin_ = ivec2(glm::ceil(glm::abs(grid.driftMm) * double(reach_) / dvec2(grid.spacingMm))) + 1;
        wide_.size += ivec3(2 * margin_, 0);
        // Interpolation reaches one cell farther than the distances that are wanted.
        const double known = reachMm + grid.longestMm();
        mm_ = withinLayers(withMargin(cells), value, wide_, known, checkpoint);
        for (float& mm : mm_)
            mm = std::min(std::sqrt(mm), float(known));
    }

    /// Writes the squared distances of layer `z`, as the cells of all layers within reach make them.
    void spread(int z, float* layer) const {
        std::fill_n(layer, grid_.sliceCount(), kFar);
        for (int other = std::max(0, z - reach_); other <= std::min(grid_.size.z - 1, z + reach_); ++other)
            for (int y = 0; y < grid_.size.y; ++y)
                lowerRow(layer + std::size_t(y) * std::size_t(grid_.size.x), y, z, other);
    }

  private:
    /// Returns the cells with a margin that is neither 0 nor 1.
    Cells withMargin(const Cells& cells) const {
        Cells wide(wide_.count(), 2);
        for (int z = 0; z < grid_.size.z; ++z)
            for (int y = 0; y < grid_.size.y; ++y)
                std::copy_n(&cells[grid_.index(0, y, z)], grid_.size.x,
                            &wide[wide_.index(margin_.x, y + margin_.y, z)]);
        return wide;
    }

    /// Lowers the row `y` of layer `z` by the distances to cells of layer `other`, linear between those of its cells.
    void lowerRow(float* row, int y, int z, int other) const {
        const dvec2 at = dvec2(margin_) + dvec2(0, y) + double(z - other) * grid_.driftMm / dvec2(grid_.spacingMm);
        const ivec2 cell(glm::floor(at));
        const vec2 share(at - dvec2(cell));
        const float* low = &mm_[wide_.index(cell.x, cell.y, other)];
        const float* high = low + wide_.size.x;
        const auto apart = float(std::pow((other - z) * grid_.spacingMm.z, 2));
        for (int x = 0; x < grid_.size.x; ++x) {
            const float mm =
                glm::mix(glm::mix(low[x], low[x + 1], share.x), glm::mix(high[x], high[x + 1], share.x), share.y);
            row[x] = std::min(row[x], mm * mm + apart);
        }
    }

    const CellGrid& grid_;
    CellGrid wide_;  ///< with the margin, in cells, on either side along i and j
    ivec2 margin_{0};
    int reach_;
    std::vector<float> mm_;  ///< within the layers of `wide_`
};

}  // namespace

/// Processes one axis after the other, as Felzenszwalb and Huttenlocher (2012) do, but only up to `reachMm`: there,
/// visiting all neighbours within reach, whole rows at a time, is faster than their lower envelope.
std::vector<float> squaredDistances(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
                                    const Checkpoint& checkpoint) {
    if (grid.driftMm != dvec2(0)) {
        std::vector<float> distances(grid.count());
        const DriftingLayers layers(cells, value, grid, reachMm, checkpoint);
        forEachSlice(grid.size.z, checkpoint, [&](int z) { layers.spread(z, &distances[grid.index(0, 0, z)]); });
        return distances;
    }
    std::vector<float> distances = withinLayers(cells, value, grid, reachMm, checkpoint);
    tbb::enumerable_thread_specific<std::vector<float>> room;
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
