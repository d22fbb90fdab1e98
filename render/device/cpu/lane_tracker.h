#pragma once
/// Many rays through the medium, kLanes at a time: a lane whose ray has ended takes the next one.

#include <array>
#include <bit>
#include <cstring>

#include "render/kernel/tracking.h"

namespace pdr {

/// A list of rays and, after track(), what became of them. Lanes are arrays, so that rays load and store in step.
class RayBatch {
  public:
    static constexpr int kCapacity = 256;

    void clear() { size_ = 0; }
    int size() const { return size_; }
    bool full() const { return size_ == kCapacity; }
    float result(int ray) const { return result_[ray]; }

    /// Adds a ray; its number is its place in the order of adding.
    void add(const Ray& ray, const RandomStream& random) {
        origin_.set(size_, ray.origin);
        direction_.set(size_, ray.direction);
        length_[size_] = ray.length;
        counter_[size_] = random.counter;
        key_[size_] = random.key;
        ++size_;
    }

    template <template <class> class Rule>
    void track(const FlatScene& scene);

  private:
    static constexpr int kIdleLanes = kLanes / 4;  ///< so many lanes wait before new rays are taken
    static constexpr std::uint32_t kAllLanes = (1u << kLanes) - 1;

    template <template <class> class Rule>
    void trackInLanes(const FlatScene& scene);
    Ray ray(int row) const;

    /// Rays [row, row + kLanes) on their way; rows from size() on are left-overs that nobody takes.
    Flight<FloatLanes> started(const FlatScene& scene, int row) const;
    void keepResults(FloatLanes result, IntLanes ray, std::uint32_t lanes);

    template <class T>
    using Column = std::array<T, kCapacity>;

    struct Columns3 {
        Column<float> x, y, z;
        void set(int row, vec3 value) { x[row] = value.x, y[row] = value.y, z[row] = value.z; }
    };

    alignas(64) Columns3 origin_, direction_;
    alignas(64) Column<float> length_, result_;
    alignas(64) Column<std::uint64_t> counter_, key_;
    int size_ = 0;
};

inline Flight<FloatLanes> RayBatch::started(const FlatScene& scene, int row) const {
    const auto load = [row](auto& lanes, const auto& column) {
        std::memcpy(&lanes, column.data() + row, sizeof lanes);
    };
    Vec3<FloatLanes> origin, direction;
    FloatLanes length;
    RandomStreamOf<FloatLanes> random;
    load(origin.x, origin_.x);
    load(origin.y, origin_.y);
    load(origin.z, origin_.z);
    load(direction.x, direction_.x);
    load(direction.y, direction_.y);
    load(direction.z, direction_.z);
    load(length, length_);
    load(random.counter, counter_);
    load(random.key, key_);
    Flight<FloatLanes> flight;
    flight.start(scene.majorants, origin, direction, length, random);
    return flight;
}

/// Lanes read voxels in pairs along x and count them in 32 bits.
inline bool lanesCanRead(const FlatVolume& volume) {
    const std::int64_t voxels = std::int64_t(volume.size.x) * volume.size.y * volume.size.z;
    return volume.size.x > 1 && voxels <= INT32_MAX;
}

template <template <class> class Rule>
inline void RayBatch::track(const FlatScene& scene) {
    if (lanesCanRead(scene.volume))
        trackInLanes<Rule>(scene);
    else
        for (int row = 0; row < size_; ++row)
            result_[row] = pdr::track<Rule>(scene, ray(row), {{counter_[row], key_[row]}});
}

inline Ray RayBatch::ray(int row) const {
    return {{origin_.x[row], origin_.y[row], origin_.z[row]},
            {direction_.x[row], direction_.y[row], direction_.z[row]},
            length_[row]};
}

template <template <class> class Rule>
inline void RayBatch::trackInLanes(const FlatScene& scene) {
    int next = 0;                                    // the first ray that no lane has taken
    Flight<FloatLanes> waiting = started(scene, 0);  // rays [next rounded down, + kLanes)
    Flight<FloatLanes> flight = waiting;
    flight.stop(IntLanes{} - 1);
    Rule<FloatLanes> rule;
    IntLanes ray = IntLanes{} - 1;  // which ray each lane has; -1: none

    for (;;) {
        std::uint32_t idle = laneBits(!flight.flying());
        if (std::popcount(idle) >= kIdleLanes && next < size_) {
            keepResults(rule.result, ray, idle);
            while (idle != 0 && next < size_) {
                if (next % kLanes == 0)
                    waiting = started(scene, next);
                IntLanes fresh{}, from{};
                do {
                    const int lane = std::countr_zero(idle);
                    idle &= idle - 1;
                    fresh[lane] = -1;
                    from[lane] = next % kLanes;
                    ray[lane] = next++;
                } while (idle != 0 && next < size_ && next % kLanes != 0);
                flight.take(fresh, waiting, from);
                rule.result = fresh ? Rule<FloatLanes>().result : rule.result;
            }
        } else if (idle == kAllLanes) {
            break;
        }
        const TentativeCollision<FloatLanes> collision = flight.step(scene);
        flight.stop(rule.endsAt(flight.t, collision));
    }
    keepResults(rule.result, ray, kAllLanes);
}

inline void RayBatch::keepResults(FloatLanes result, IntLanes ray, std::uint32_t lanes) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        if (ray[lane] >= 0)
            result_[ray[lane]] = result[lane];
    }
}

}  // namespace pdr
