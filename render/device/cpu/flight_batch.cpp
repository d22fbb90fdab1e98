#include "render/device/cpu/flight_batch.h"

namespace pdr {

/// Presents the batch as a list of rays for walkInLanes().
template <class Walk>
struct FlightBatch::InLanes {
    FlightBatch& batch;

    int size() const { return batch.size_; }
    Walk started(const FlatScene& scene, int row) const {
        const RayColumns<kCapacity>& rays = batch.rays_;
        Walk walk;
        walk.start(scene, rays.origins(row), rays.directions(row), rays.lengths(row), rays.lanes(batch.depth_, row),
                   randomOf(row));
        if constexpr (Walk::kEnd == FlightEnd::places)
            walk.goOnTo(rays.lanes(batch.furtherDepth_, row));
        return walk;
    }
    RandomStreamOf<FloatLanes> randomOf(int row) const {
        RandomStreamOf<FloatLanes> random;
        std::memcpy(&random.counter, batch.counter_.data() + row, sizeof random.counter);
        std::memcpy(&random.key, batch.key_.data() + row, sizeof random.key);
        return random;
    }
    void keep(const FlatScene&, const Walk& walk, int lane, int ray) {
        batch.distance_[ray] = walk.distance[lane];
        batch.passed_[ray] = walk.passed[lane];
        if constexpr (Walk::kEnd == FlightEnd::places)
            batch.furtherDistance_[ray] = walk.further[lane];
    }
};

template <class Walk>
void FlightBatch::flyInLanes(const FlatScene& scene) {
    InLanes<Walk> rays{*this};
    walkInLanes<Walk>(rays, scene);
}

template <FlightEnd End, ThinTissue Thin>
void FlightBatch::flyAll(const FlatScene& scene) {
    if (lanesCanRead(scene.volume))
        return forTissue(scene, [&]<Tissue Kind>() { flyInLanes<FlightFor<FloatLanes, Kind, End, Thin>>(scene); });
    for (int row = 0; row < size_; ++row) {
        const Flight flight = Thin == ThinTissue::solved
                                  ? freeFlight<End>(scene, rays_.at(row), depth_[row], furtherDepth_[row])
                                  : lookFlight<End, Thin>(scene, rays_.at(row), depth_[row],
                                                          RandomStream{{counter_[row], key_[row]}}, furtherDepth_[row]);
        distance_[row] = flight.distance;
        furtherDistance_[row] = flight.further;
        passed_[row] = flight.passed;
    }
}

void FlightBatch::fly(const FlatScene& scene, FlightEnd end) {
    end == FlightEnd::whether ? flyAll<FlightEnd::whether, ThinTissue::solved>(scene)
                              : flyAll<FlightEnd::places, ThinTissue::solved>(scene);
}

void FlightBatch::flyByLooks(const FlatScene& scene, FlightEnd end) {
    if (end != FlightEnd::whether)
        flyAll<FlightEnd::places, ThinTissue::looked>(scene);
    else if (scene.lightLooks)
        flyAll<FlightEnd::whether, ThinTissue::allLooked>(scene);
    else
        flyAll<FlightEnd::whether, ThinTissue::looked>(scene);
}

}  // namespace pdr
