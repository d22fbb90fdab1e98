#pragma once
/// Traces many free flights, kLanes at a time.

#include <array>

#include "render/device/cpu/lane_group.h"
#include "render/kernel/transport/free_flight.h"

namespace pdr {

/// A list of rays, each with the optical depth that it flies, and, after fly(), their results.
class FlightBatch {
  public:
    static constexpr int kCapacity = 1024;

    void clear() { size_ = 0; }
    int size() const { return size_; }
    /// Return the result of a ray; see Flight.
    float distance(int ray) const { return distance_[ray]; }
    float further(int ray) const { return furtherDistance_[ray]; }
    float passed(int ray) const { return passed_[ray]; }

    /// Adds a ray; its number is its place in the order of adding. `random`: for looks.
    void add(const Ray& ray, float depth, const RandomStream& random = {}) { add(ray, depth, depth, random); }
    /// Adds a ray that passes two depths, for FlightEnd::places.
    void add(const Ray& ray, float nearer, float further, const RandomStream& random) {
        rays_.set(size_, ray);
        depth_[size_] = nearer;
        furtherDepth_[size_] = further;
        counter_[size_] = random.counter;
        key_[size_] = random.key;
        ++size_;
    }

    /// Flies all rays to their ends as freeFlight() does; flyByLooks() as firstFlight() does in a scene that looks.
    void fly(const FlatScene& scene, FlightEnd end = FlightEnd::places);
    void flyByLooks(const FlatScene& scene, FlightEnd end = FlightEnd::places);

  private:
    template <class Walk>
    struct InLanes;
    template <FlightEnd End, ThinTissue Thin>
    void flyAll(const FlatScene& scene);
    template <class Walk>
    void flyInLanes(const FlatScene& scene);

    alignas(64) RayColumns<kCapacity> rays_;
    alignas(64) std::array<float, kCapacity> depth_, furtherDepth_, distance_, furtherDistance_, passed_;
    alignas(64) std::array<std::uint64_t, kCapacity> counter_, key_;
    int size_ = 0;
};

}  // namespace pdr
