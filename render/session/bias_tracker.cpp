/// When the bias of images is measured, and which one next.

#include "render/session/bias_tracker.h"

#include "render/session/known_bias.h"

namespace pdr {

void BiasTracker::clear() {
    measurements_.reset();
    tone_.reset();
}

bool BiasTracker::isDue() const {
    return clock_() - measuredAt_ >= seconds_ / kShare;
}

Result<void> BiasTracker::measure(FilmOnDevice& place, const Scene& scene, std::uint64_t samples, const Tone& tone,
                                  const std::stop_token& stop) {
    if (!measurements_)
        measurements_.emplace(scene, biasFacts(scene, {}, place.info().name));
    BiasLattice* lattice = measurements_->next(samples, known(tone));
    if (lattice == nullptr)
        return {};
    const double start = clock_();
    Result<void> done = place.lend([&](Device& device) { return lattice->addRound(device, stop); });
    measuredAt_ = clock_();
    seconds_ = measuredAt_ - start;
    tone_.reset();
    return done;
}

MeasuredBiases BiasTracker::known(const Tone& tone) {
    if (!measurements_)
        return {};
    if (tone_ != tone) {
        tone_ = tone;
        known_ = measurements_->measured(tone);
    }
    return known_;
}

}  // namespace pdr
