/// How the render thread measures what its pictures are off for good, where they are made in a way that has a bias.

#include "render/session/known_bias.h"
#include "render/session/loop.h"

namespace pdr {

namespace {

constexpr double kBiasShare = 0.02;  ///< of the time, at most, after the first round

}  // namespace

/// Whether anything has to be measured at all is asked once for each film. Null: nothing, or all is known.
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

/// A round between two frames, at rest; it ends as soon as anything else is wanted.
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
