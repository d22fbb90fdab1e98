#pragma once
/// Walks many rays, kLanes at a time: a lane whose ray has ended takes the next one.
///   Walk   the state of the lanes: going(), step(scene), take(mask, started walk, from)
///   Rays   the list: size(), started(scene, row) with rows [row, row + kLanes) before their first step, and
///          keep(scene, walk, lane, ray) to store the result of one

#include <array>
#include <bit>
#include <cstring>

#include "render/base/lanes.h"
#include "render/kernel/flat_grid.h"
#include "render/kernel/ray.h"

namespace pdr {

/// A group of kLanes rays in lockstep. A lane whose ray has ended waits until kIdleLanes do; then they take new rays
/// together.
template <class Walk, class Rays>
class LaneGroup {
  public:
    LaneGroup(Rays& rays, const FlatScene& scene) : rays_(rays), scene_(scene) {}

    /// Makes one step; false if no ray is left. `next`: the first ray that is not taken yet.
    [[gnu::noinline]] bool step(int& next) {
        const std::uint32_t idle = laneBits(!walk_.going());
        if (std::popcount(idle) >= kIdleLanes && next < rays_.size())
            takeRays(idle, next);
        else if (idle == kAllLanes)
            return false;
        walk_.step(scene_);
        return true;
    }

    void keepAll() { keep(kAllLanes); }

  private:
    static constexpr int kIdleLanes = kLanes > 4 ? 2 : 1;  ///< number of idle lanes at which new rays are taken
    static constexpr std::uint32_t kAllLanes = (1u << kLanes) - 1;

    void keep(std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            if (ray_[lane] >= 0)
                rays_.keep(scene_, walk_, lane, ray_[lane]);
        }
    }

    void takeRays(std::uint32_t idle, int& next) {
        keep(idle);
        while (idle != 0 && next < rays_.size()) {
            const int first = next / kLanes * kLanes;
            if (first != waitingFrom_) {
                waiting_ = rays_.started(scene_, first);
                waitingFrom_ = first;
            }
            IntLanes fresh{}, from{};
            do {
                const int lane = std::countr_zero(idle);
                idle &= idle - 1;
                fresh[lane] = -1;
                from[lane] = next % kLanes;
                ray_[lane] = next++;
            } while (idle != 0 && next < rays_.size() && next % kLanes != 0);
            walk_.take(fresh, waiting_, from);
        }
    }

    Rays& rays_;
    const FlatScene& scene_;
    Walk walk_, waiting_;
    int waitingFrom_ = -1;           ///< the ray in lane 0 of waiting_
    IntLanes ray_ = IntLanes{} - 1;  ///< the ray of each lane; -1: none
};

/// Walks all rays to their ends. Two groups take turns: while one waits for the memory, the other computes.
template <class Walk, class Rays>
void walkInLanes(Rays& rays, const FlatScene& scene) {
    LaneGroup<Walk, Rays> a(rays, scene), b(rays, scene);
    int next = 0;
    bool going = true;
    while (going) {
        going = a.step(next);
        going = b.step(next) || going;
    }
    a.keepAll();
    b.keepAll();
}

/// Rays stored by columns, so that lanes load them together.
template <int Capacity>
struct RayColumns {
    void set(int row, const Ray& ray) {
        originX[row] = ray.origin.x, originY[row] = ray.origin.y, originZ[row] = ray.origin.z;
        directionX[row] = ray.direction.x, directionY[row] = ray.direction.y, directionZ[row] = ray.direction.z;
        length[row] = ray.length;
    }
    Ray at(int row) const {
        return {{originX[row], originY[row], originZ[row]},
                {directionX[row], directionY[row], directionZ[row]},
                length[row]};
    }
    Vec3<FloatLanes> origins(int row) const { return {lanes(originX, row), lanes(originY, row), lanes(originZ, row)}; }
    Vec3<FloatLanes> directions(int row) const {
        return {lanes(directionX, row), lanes(directionY, row), lanes(directionZ, row)};
    }
    FloatLanes lengths(int row) const { return lanes(length, row); }

    using Column = std::array<float, Capacity>;
    static FloatLanes lanes(const Column& column, int row) {
        FloatLanes values;
        std::memcpy(&values, column.data() + row, sizeof values);
        return values;
    }

    alignas(64) Column originX, originY, originZ, directionX, directionY, directionZ, length;
};

}  // namespace pdr
