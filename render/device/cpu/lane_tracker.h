#pragma once
/// Tracks many rays through the medium, kLanes at a time.

#include <array>
#include <vector>

#include "render/device/cpu/lane_group.h"
#include "render/kernel/transport/tracking.h"

namespace pdr {

/// A list of rays and, after track(), their results. It stores arrays, so that lanes load and store rays together.
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
    /// Returns the rays that met an extinction above its bound, in no order.
    const std::vector<int>& overMajorant() const { return overMajorant_; }

    /// Adds a ray; its number is its place in the order of adding.
    void add(const Ray& ray, const RandomStream& random) {
        rays_.set(size_, ray);
        counter_[size_] = random.counter;
        key_[size_] = random.key;
        ++size_;
    }

    /// Tracks all rays. Estimator: DeltaTracking or RatioTracking. Compiled apart from the kernels, since all of them
    /// share it.
    template <template <class> class Estimator>
    void track(const FlatScene& scene);

  private:
    template <template <class> class Estimator, bool Dense>
    struct Tracked;
    template <template <class> class Estimator, bool Dense>
    void trackInLanes(const FlatScene& scene);

    alignas(64) RayColumns<kCapacity> rays_;
    alignas(64) std::array<float, kCapacity> result_;
    alignas(64) std::array<std::uint64_t, kCapacity> counter_, key_;
    std::vector<int> overMajorant_;
    int size_ = 0;
};

}  // namespace pdr
