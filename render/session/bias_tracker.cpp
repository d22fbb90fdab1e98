/// When the bias of images is measured, and which one next.

#include "render/session/bias_tracker.h"

#include "render/session/known_bias.h"

namespace pdr {

void BiasTracker::clear() {
    measurements_.reset();
    exposure_ = 0;
}

bool BiasTracker::isDue() const {
    return clock_() - measuredAt_ >= seconds_ / kShare;
}

Result<void> BiasTracker::measure(FilmOnDevice& place, const Scene& scene, std::uint64_t samples, float exposure,
                                  const std::stop_token& stop) {
    if (!measurements_)
        measurements_.emplace(scene, biasFacts(scene, {}, place.info().name));
    BiasLattice* lattice = measurements_->next(samples, known(exposure));
    if (lattice == nullptr)
        return {};
    const double start = clock_();
    Result<void> done = place.lend([&](Device& device) { return lattice->addRound(device, stop); });
    measuredAt_ = clock_();
    seconds_ = measuredAt_ - start;
    exposure_ = 0;
    return done;
}

MeasuredBiases BiasTracker::known(float exposure) {
    if (!measurements_)
        return {};
    if (exposure_ != exposure) {
        exposure_ = exposure;
        known_ = measurements_->measured(double(exposure));
    }
    return known_;
}

}  // namespace pdr
