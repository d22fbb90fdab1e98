#pragma once
/// Delta tracking in two plain ways, to compare the renderer's own with: with one majorant for the whole volume, and
/// over cells of one size. Both are exact, as the renderer's own is. The template parameter Count is Work, or NoCount
/// where time is measured.

#include <algorithm>
#include <vector>

#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"

namespace pdr::bench {

/// Counters of the work that rays take.
struct Work {
    long fetches = 0;  ///< extinctions looked up in the volume
    long cells = 0;    ///< cells traversed
    void fetch() { ++fetches; }
    void cell() { ++cells; }
};

struct NoCount {
    void fetch() {}
    void cell() {}
};

/// Returns the distance of the first collision [mm], or -1. `majorant` bounds the extinction everywhere [1/mm], above
/// 0.
template <class Count>
float trackGlobal(const FlatScene& scene, const Ray& ray, RandomStream random, float majorant, Count& count) {
    const Interval<float> inside = clipped(ray.origin, ray.direction, scene.majorants.occupiedLow,
                                           scene.majorants.occupiedHigh, Interval<float>{0, ray.length});
    float t = inside.enter;
    while (true) {
        const vec2 u = random.pair();
        t += negativeLog(u.x) / majorant;
        if (!(t < inside.leave))
            return -1;
        count.fetch();
        if (u.y * majorant < extinction(scene, ray.origin + ray.direction * t))
            return t;
    }
}

/// Majorants in cells of 8^3 voxels; cell (i,j,k) holds the points with index coordinates in [8i - 4, 8i + 4] and so
/// on.
class SingleLevelGrid {
  public:
    explicit SingleLevelGrid(const FlatMajorants& grid)
        : size_(grid.fineSize / 2), low_(grid.occupiedLow), high_(grid.occupiedHigh) {
        bounds_.resize(std::size_t(size_.x) * size_.y * size_.z);
        for (int k = 0; k < grid.fineSize.z; ++k)
            for (int j = 0; j < grid.fineSize.y; ++j)
                for (int i = 0; i < grid.fineSize.x; ++i) {
                    float& bound = bounds_[at({i / 2, j / 2, k / 2})];
                    bound = std::max(bound, grid.fine[(std::size_t(k) * grid.fineSize.y + j) * grid.fineSize.x + i]);
                }
    }

    /// Does the same as trackGlobal(), but from cell to cell after Amanatides & Woo 1987; what is left of the optical
    /// depth is carried on to the next cell.
    template <class Count>
    float track(const FlatScene& scene, const Ray& ray, RandomStream random, Count& count) const {
        const Interval<float> inside = clipped(ray.origin, ray.direction, low_, high_, Interval<float>{0, ray.length});
        float t = inside.enter;
        if (!(t < inside.leave))
            return -1;
        Walk walk(*this, ray, t);
        vec2 u = random.pair();
        float depth = negativeLog(u.x);
        while (true) {
            count.cell();
            const int axis = walk.nearestAxis();
            const float leave = std::clamp(walk.next[axis], t, inside.leave);
            const float bound = bounds_[walk.index];
            while (depth < bound * (leave - t)) {
                t += depth / bound;
                count.fetch();
                if (u.y * bound < extinction(scene, ray.origin + ray.direction * t))
                    return t;
                u = random.pair();
                depth = negativeLog(u.x);
            }
            depth -= bound * (leave - t);
            t = leave;
            if (!(t < inside.leave) || !walk.advance(axis))
                return -1;
        }
    }

  private:
    std::int64_t at(ivec3 cell) const { return (std::int64_t(cell.z) * size_.y + cell.y) * size_.x + cell.x; }

    struct Walk {
        std::int64_t index;
        ivec3 left;  ///< cells that lie ahead along each axis
        std::int64_t step[3];
        vec3 next, perCell;  ///< distance to the border of the cell, and from border to border [mm]

        Walk(const SingleLevelGrid& grid, const Ray& ray, float t) {
            const vec3 start = ray.origin + ray.direction * t;
            const ivec3 cell = glm::clamp(ivec3((start + 4.0f) / 8.0f), ivec3(0), grid.size_ - 1);
            const std::int64_t stride[3] = {1, grid.size_.x, std::int64_t(grid.size_.x) * grid.size_.y};
            index = grid.at(cell);
            for (int axis = 0; axis < 3; ++axis) {
                const float along = std::fabs(ray.direction[axis]) < 1e-20f ? 1e-20f : ray.direction[axis];
                const bool up = along > 0;
                left[axis] = up ? grid.size_[axis] - 1 - cell[axis] : cell[axis];
                step[axis] = up ? stride[axis] : -stride[axis];
                next[axis] = (float(8 * (cell[axis] + up) - 4) - ray.origin[axis]) / along;
                perCell[axis] = 8 / std::fabs(along);
            }
        }
        int nearestAxis() const {
            const int low = next.x < next.y ? 0 : 1;
            return next[low] < next.z ? low : 2;
        }
        bool advance(int axis) {
            index += step[axis];
            next[axis] += perCell[axis];
            return left[axis]-- > 0;
        }
    };

    std::vector<float> bounds_;
    ivec3 size_;
    vec3 low_, high_;  ///< box in index space outside of which the extinction is 0
};

}  // namespace pdr::bench
