#include "render/device/cpu/lane_tracker.h"

namespace pdr {

namespace {

/// kLanes rays on their way, and what the rule made of them so far.
template <template <class> class Rule>
struct TrackingWalk {
    Flight<FloatLanes> flight{};
    Rule<FloatLanes> rule;

    IntLanes going() const { return flight.flying(); }
    PDR_HD_INLINE void step(const FlatScene& scene) {
        const TentativeCollision<FloatLanes> collision = flight.step(scene);
        flight.stop(rule.endsAt(flight.t, collision));
    }
    void take(IntLanes fresh, const TrackingWalk& other, IntLanes from) {
        flight.take(fresh, other.flight, from);
        rule.result = fresh ? Rule<FloatLanes>().result : rule.result;
    }
};

}  // namespace

/// The batch as a list of rays for lanes.
template <template <class> class Rule>
struct RayBatch::Tracked {
    RayBatch& batch;

    int size() const { return batch.size_; }
    TrackingWalk<Rule> started(const FlatScene& scene, int row) const {
        RandomStreamOf<FloatLanes> random;
        std::memcpy(&random.counter, batch.counter_.data() + row, sizeof random.counter);
        std::memcpy(&random.key, batch.key_.data() + row, sizeof random.key);
        TrackingWalk<Rule> walk;
        walk.flight.start(scene.majorants, batch.rays_.origins(row), batch.rays_.directions(row),
                          batch.rays_.lengths(row), random);
        return walk;
    }
    void keep(const FlatScene&, const TrackingWalk<Rule>& walk, int lane, int ray) {
        batch.result_[ray] = walk.rule.result[lane];
    }
};

template <template <class> class Rule>
void RayBatch::track(const FlatScene& scene) {
    Tracked<Rule> rays{*this};
    if (lanesCanRead(scene.volume))
        walkInLanes<TrackingWalk<Rule>>(rays, scene);
    else
        for (int row = 0; row < size_; ++row)
            result_[row] = pdr::track<Rule>(scene, rays_.at(row), {{counter_[row], key_[row]}});
}

template void RayBatch::track<DeltaTracking>(const FlatScene& scene);
template void RayBatch::track<RatioTracking>(const FlatScene& scene);

}  // namespace pdr
