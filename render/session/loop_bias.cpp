/// How the render thread measures what its pictures are off for good, where they are made in a way that has a bias.

#include "render/session/known_bias.h"
#include "render/session/loop.h"

namespace pdr {

namespace {

constexpr double kBiasShare = 0.05;           ///< of the time, at most, after the first round
constexpr double kSureEnough = 1.25;          ///< from the estimate to either end of its interval
constexpr std::uint64_t kMostSamples = 4096;  ///< of each pixel of the lattice

bool isSure(const Between& levels) {
    return levels.low > 0 && levels.high <= kSureEnough * levels.value && levels.value <= kSureEnough * levels.low;
}

}  // namespace

/// Whether it has to be measured at all is asked once for each film.
bool Session::Loop::seeksBias() {
    if (!latticeSought_ && needsMeasuring(biasFacts(scene_, {}, place_.info().name)))
        lattice_.emplace(scene_);
    latticeSought_ = true;
    if (!lattice_ || lattice_->samples() >= kMostSamples)
        return false;
    const auto known = knownBias(commands.display().exposure);
    return !known || !isSure(known->levels);
}

/// Nothing without a round.
std::optional<MeasuredBias> Session::Loop::knownBias(float exposure) {
    if (!lattice_ || lattice_->samples() == 0)
        return std::nullopt;
    if (biasExposure_ != exposure) {
        biasExposure_ = exposure;
        bias_ = lattice_->measured(exposure);
    }
    return bias_;
}

/// A round between two frames, at rest; it ends as soon as anything else is wanted.
Result<void> Session::Loop::measureBias(const RenderCommands::Iteration& step) {
    if (secondsSince(biasAt_) < biasSeconds_ / kBiasShare || step.detour.stop_requested() || !seeksBias())
        return {};
    const double start = clock_();
    Result<void> done = place_.lend([&](Device& device) { return lattice_->addRound(device, step.detour); });
    biasAt_ = clock_();
    biasSeconds_ = secondsSince(start);
    biasExposure_ = 0;
    return done;
}

}  // namespace pdr
