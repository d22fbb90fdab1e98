#include "render/device/cpu/flight_batch.h"

namespace pdr {

/// Presents the batch as a list of rays for walkInLanes().
template <class Walk>
struct FlightBatch::InLanes {
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

template <class Walk>
void FlightBatch::flyInLanes(const FlatScene& scene) {
    InLanes<Walk> rays{*this};
    walkInLanes<Walk>(rays, scene);
}

template <FlightEnd End>
void FlightBatch::flyAll(const FlatScene& scene) {
    if (lanesCanRead(scene.volume))
        return isMasked(scene) ? flyInLanes<FreeFlight<FloatLanes, true, End>>(scene)
                               : flyInLanes<FreeFlight<FloatLanes, false, End>>(scene);
    for (int row = 0; row < size_; ++row) {
        const Flight flight = freeFlight<End>(scene, rays_.at(row), depth_[row]);
        distance_[row] = flight.distance;
        passed_[row] = flight.passed;
    }
}

void FlightBatch::fly(const FlatScene& scene, FlightEnd end) {
    end == FlightEnd::place ? flyAll<FlightEnd::place>(scene) : flyAll<FlightEnd::whether>(scene);
}

}  // namespace pdr
