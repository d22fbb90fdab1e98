#include "render/device/cpu/flight_batch.h"

namespace pdr {

/// Presents the batch as a list of rays for walkInLanes().
template <bool Masked>
struct FlightBatch::InLanes {
    using Walk = FreeFlight<FloatLanes, Masked>;
    FlightBatch& batch;

    int size() const { return batch.size_; }
    Walk started(const FlatScene& scene, int row) const {
        Walk walk;
        walk.start(scene, batch.rays_.origins(row), batch.rays_.directions(row), batch.rays_.lengths(row),
                   batch.rays_.lanes(batch.depth_, row));
        return walk;
    }
    void keep(const FlatScene&, const Walk& walk, int lane, int ray) {
        batch.distance_[ray] = walk.distance[lane];
        batch.passed_[ray] = walk.passed[lane];
    }
};

template <bool Masked>
void FlightBatch::flyInLanes(const FlatScene& scene) {
    InLanes<Masked> rays{*this};
    walkInLanes<FreeFlight<FloatLanes, Masked>>(rays, scene);
}

void FlightBatch::fly(const FlatScene& scene) {
    if (lanesCanRead(scene.volume))
        return isMasked(scene) ? flyInLanes<true>(scene) : flyInLanes<false>(scene);
    for (int row = 0; row < size_; ++row) {
        const Flight flight = freeFlight(scene, rays_.at(row), depth_[row]);
        distance_[row] = flight.distance;
        passed_[row] = flight.passed;
    }
}

}  // namespace pdr
