#include "render/device/cpu/lane_tracker.h"

#include <cmath>

namespace pdr {

namespace {

/// A group of kLanes rays on their way, with the state of the estimator.
template <template <class> class Estimator, bool Dense>
struct TrackingWalk {
    MajorantTraversal<FloatLanes, Dense> flight{};
    Estimator<FloatLanes> estimator;
    IntLanes overMajorant{};  ///< whether the ray has met an extinction above its bound
    IntLanes steps{};         ///< steps of the ray so far; see kMostSteps

    IntLanes going() const { return flight.isActive(); }
    PDR_HD_INLINE void step(const FlatScene& scene) {
        const TentativeCollision<FloatLanes> collision = flight.step(scene);
        overMajorant = overMajorant | (collision.happened & (collision.extinction > collision.majorant));
        flight.stop(estimator.onCollision(flight.t, collision));
        if constexpr (Dense)
            endWhatNeverEnds();
    }
    PDR_HD_INLINE void endWhatNeverEnds() {
        steps = steps + 1;
        const IntLanes endless = (steps >= kMostSteps) & flight.isActive();
        estimator.result = endless ? FloatLanes{} + NAN : estimator.result;
        flight.stop(endless);
    }
    void take(IntLanes fresh, const TrackingWalk& other, IntLanes from) {
        flight.take(fresh, other.flight, from);
        overMajorant = overMajorant & ~fresh;
        if constexpr (Dense)
            steps = steps & ~fresh;
        estimator.result = fresh ? Estimator<FloatLanes>().result : estimator.result;
    }
};

}  // namespace

/// Presents the batch as a list of rays for walkInLanes().
template <template <class> class Estimator, bool Dense>
struct RayBatch::Tracked {
    using Walk = TrackingWalk<Estimator, Dense>;
    RayBatch& batch;

    int size() const { return batch.size_; }
    Walk started(const FlatScene& scene, int row) const {
        RandomStreamOf<FloatLanes> random;
        std::memcpy(&random.counter, batch.counter_.data() + row, sizeof random.counter);
        std::memcpy(&random.key, batch.key_.data() + row, sizeof random.key);
        Walk walk;
        walk.flight.start(scene.majorants, batch.rays_.origins(row), batch.rays_.directions(row),
                          batch.rays_.lengths(row), random);
        return walk;
    }
    void keep(const FlatScene&, const Walk& walk, int lane, int ray) {
        batch.result_[ray] = walk.estimator.result[lane];
        if (walk.overMajorant[lane]) [[unlikely]]
            batch.overMajorant_.push_back(ray);
    }
};

template <template <class> class Estimator, bool Dense>
void RayBatch::trackInLanes(const FlatScene& scene) {
    Tracked<Estimator, Dense> rays{*this};
    walkInLanes<TrackingWalk<Estimator, Dense>>(rays, scene);
}

template <template <class> class Estimator>
void RayBatch::track(const FlatScene& scene) {
    if (lanesCanRead(scene.volume) && scene.majorants.dense)
        trackInLanes<Estimator, true>(scene);
    else if (lanesCanRead(scene.volume))
        trackInLanes<Estimator, false>(scene);
    else
        for (int row = 0; row < size_; ++row) {
            bool over = false;
            result_[row] = pdr::track<Estimator>(scene, rays_.at(row), {{counter_[row], key_[row]}}, over);
            if (over)
                overMajorant_.push_back(row);
        }
}

template void RayBatch::track<DeltaTracking>(const FlatScene& scene);
template void RayBatch::track<RatioTracking>(const FlatScene& scene);

}  // namespace pdr
