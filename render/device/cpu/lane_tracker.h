#pragma once
/// Many rays through the medium, kLanes at a time: a lane whose ray has ended takes the next one.

#include <array>
#include <vector>

#include "render/kernel/tracking.h"

namespace pdr {

/// A list of rays and, after track(), what became of them. Lanes are arrays, so that rays load and store in step.
class RayBatch {
  public:
    static constexpr int kCapacity = 512;

    void clear() {
        size_ = 0;
        overMajorant_.clear();
    }
    int size() const { return size_; }
    bool full() const { return size_ == kCapacity; }
    float result(int ray) const { return result_[ray]; }
    /// Rays that met an extinction above its bound; a ray may be there twice.
    const std::vector<int>& overMajorant() const { return overMajorant_; }

    /// Adds a ray; its number is its place in the order of adding.
    void add(const Ray& ray, const RandomStream& random) {
        origin_.set(size_, ray.origin);
        direction_.set(size_, ray.direction);
        length_[size_] = ray.length;
        counter_[size_] = random.counter;
        key_[size_] = random.key;
        ++size_;
    }

    /// Rule: DeltaTracking or RatioTracking. Compiled apart from the kernels: it is the same for all of them.
    template <template <class> class Rule>
    void track(const FlatScene& scene);

  private:
    static constexpr int kIdleLanes = kLanes / 4;  ///< so many lanes wait before new rays are taken
    static constexpr std::uint32_t kAllLanes = (1u << kLanes) - 1;

    template <template <class> class Rule>
    class LaneGroup;
    template <template <class> class Rule>
    void trackInLanes(const FlatScene& scene);
    Ray ray(int row) const;

    /// Rays [row, row + kLanes) on their way; rows from size() on are left-overs that nobody takes.
    Flight<FloatLanes> started(const FlatScene& scene, int row) const;

    template <class T>
    using Column = std::array<T, kCapacity>;

    struct Columns3 {
        Column<float> x, y, z;
        void set(int row, vec3 value) { x[row] = value.x, y[row] = value.y, z[row] = value.z; }
    };

    alignas(64) Columns3 origin_, direction_;
    alignas(64) Column<float> length_, result_;
    alignas(64) Column<std::uint64_t> counter_, key_;
    std::vector<int> overMajorant_;
    int size_ = 0;
};

}  // namespace pdr
