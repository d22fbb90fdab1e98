/// How the render thread measures the bias of its images, if they are made in a biased way.

#include "render/session/known_bias.h"
#include "render/session/loop.h"

namespace pdr {

namespace {

constexpr double kBiasShare = 0.02;  ///< largest fraction of the time, after the first round

}  // namespace

/// Returns the lattice to measure next; null if there is nothing to measure or everything is known. What has to be
/// measured is determined once per film.
BiasLattice* Session::Loop::nextLattice() {
    if (!biasMeasurements_)
        biasMeasurements_.emplace(scene_, biasFacts(scene_, {}, place_.info().name));
    return biasMeasurements_->next(sweep_.samples().least, knownBias(commands.display().exposure));
}

MeasuredBiases Session::Loop::knownBias(float exposure) {
    if (biasMeasurements_ && biasExposure_ != exposure) {
        biasExposure_ = exposure;
        bias_ = biasMeasurements_->measured(double(exposure));
    }
    return biasMeasurements_ ? bias_ : MeasuredBiases();
}

/// Measures one round between two frames, at rest. Any other request interrupts it.
Result<void> Session::Loop::measureBias(const RenderCommands::Iteration& step) {
    if (secondsSince(biasAt_) < biasSeconds_ / kBiasShare || step.detour.stop_requested())
        return {};
    BiasLattice* lattice = nextLattice();
    if (lattice == nullptr)
        return {};
    const double start = clock_();
    Result<void> done = place_.lend([&](Device& device) { return lattice->addRound(device, step.detour); });
    biasAt_ = clock_();
    biasSeconds_ = secondsSince(start);
    biasExposure_ = 0;
    return done;
}

}  // namespace pdr
