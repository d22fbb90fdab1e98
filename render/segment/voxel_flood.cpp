#include "render/segment/voxel_flood.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "render/segment/smoothed_hu.h"

namespace pdr::segment {
namespace {

constexpr int kLevels = 256, kLevelHu = 8;  ///< steps of the gradient

class Flood {
  public:
    Flood(const Volume& hu, Marks& marks) : hu_(hu), size_(hu.size()), marks_(marks) {}

    void run(const Checkpoint& checkpoint) {
        pushMarkers(checkpoint);
        std::size_t done = 0;
        for (int level = 0; level < kLevels; ++level)
            for (std::size_t next = 0; next < queues_[std::size_t(level)].size(); ++next) {
                if (++done % kRound == 0)
                    checkpoint();
                spread(queues_[std::size_t(level)][next], level);
            }
    }

  private:
    static constexpr std::size_t kRound = 1 << 16;

    std::size_t indexOf(ivec3 at) const {
        return (std::size_t(at.z) * std::size_t(size_.y) + std::size_t(at.y)) * std::size_t(size_.x) +
               std::size_t(at.x);
    }
    ivec3 placeOf(std::size_t index) const {
        const auto x = std::size_t(size_.x), slice = x * std::size_t(size_.y);
        return {int(index % x), int(index % slice / x), int(index / slice)};
    }

    /// Calls use(index, place) for the neighbours of a place that share a face with it.
    template <class Use>
    void forNeighbours(ivec3 at, const Use& use) const {
        for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                ivec3 there = at;
                there[axis] += step;
                if (there[axis] >= 0 && there[axis] < size_[axis])
                    use(indexOf(there), there);
            }
    }

    /// Returns the level of the gradient: the sum of the differences along the axes.
    int levelAt(ivec3 at) const {
        int sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            ivec3 low = at, high = at;
            low[axis] = std::max(at[axis] - 1, 0);
            high[axis] = std::min(at[axis] + 1, size_[axis] - 1);
            sum += std::abs(smoothedAt(hu_, high) - smoothedAt(hu_, low));
        }
        return std::min(sum / (2 * kLevelHu), kLevels - 1);
    }

    /// Queues the markers that touch an open voxel.
    void pushMarkers(const Checkpoint& checkpoint) {
        std::size_t index = 0;
        for (int z = 0; z < size_.z; ++z) {
            checkpoint();
            for (int y = 0; y < size_.y; ++y)
                for (int x = 0; x < size_.x; ++x, ++index)
                    if (marks_[index] != kOpen && marks_[index] != kWall && touchesOpen({x, y, z}))
                        queues_[0].push_back(index);
        }
    }
    bool touchesOpen(ivec3 at) const {
        bool touches = false;
        forNeighbours(at, [&](std::size_t there, ivec3) { touches = touches || marks_[there] == kOpen; });
        return touches;
    }

    /// Marks the open neighbours of a voxel and queues them, none below the level of the flood.
    void spread(std::size_t index, int level) {
        const std::uint8_t mark = marks_[index];
        forNeighbours(placeOf(index), [&](std::size_t there, ivec3 place) {
            if (marks_[there] != kOpen)
                return;
            marks_[there] = mark;
            queues_[std::size_t(std::max(level, levelAt(place)))].push_back(there);
        });
    }

    const Volume& hu_;
    ivec3 size_;
    Marks& marks_;
    std::array<std::vector<std::size_t>, kLevels> queues_;
};

}  // namespace

void flood(const Volume& hu, Marks& marks, const Checkpoint& checkpoint) {
    Flood(hu, marks).run(checkpoint);
}

}  // namespace pdr::segment
