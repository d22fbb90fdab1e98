#include "render/session/bias_measurements.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "render/device/device.h"
#include "render/film/film_status.h"
#include "render/session/known_bias.h"

namespace pdr {
namespace {

constexpr double kSureEnough = 1.25;  ///< largest factor from the estimate to either end of its interval
constexpr std::uint64_t kMostSamples = 4096, kMostOfRays = 64;

bool isSure(const std::optional<MeasuredBias>& bias) {
    if (!bias)
        return false;
    const auto& [value, low, high] = bias->levels;
    return low > 0 && high <= kSureEnough * value && value <= kSureEnough * low;
}

}  // namespace

BiasMeasurements::BiasMeasurements(const Scene& scene, const BiasFacts& facts) {
    const auto add = [&](std::optional<MeasuredBias> MeasuredBiases::*result, TwoWays ways, std::uint64_t most) {
        all_.push_back({result, BiasLattice(std::move(ways)), most});
    };
    if (!shortcutNames(facts).empty())
        add(&MeasuredBiases::shortcuts, withoutShortcuts(scene), kMostSamples);
    if (keepsRunningMean(facts))
        add(&MeasuredBiases::runningMean, withoutRounding(scene), kMostSamples);
    if (sumsToATolerance(facts))
        add(&MeasuredBiases::quadrature, withoutTolerance(scene), kMostOfRays);
}

MeasuredBiases BiasMeasurements::measured(const Tone& tone) const {
    MeasuredBiases biases;
    for (const Measurement& each : all_)
        if (each.lattice.samples() > 0)
            biases.*each.result = each.lattice.measured(tone);
    return biases;
}

/// The rounding error grows with the samples; all other biases are the same from the first sample on.
bool BiasMeasurements::Measurement::hasWork(std::uint64_t samples, const MeasuredBiases& known) const {
    if (lattice.samples() == 0)
        return true;
    if (result == &MeasuredBiases::runningMean)
        return lattice.samples() < std::min(samples, mostSamples);
    return lattice.samples() < mostSamples && !isSure(known.*result);
}

BiasLattice* BiasMeasurements::next(std::uint64_t samples, const MeasuredBiases& known) {
    BiasLattice* next = nullptr;
    for (Measurement& each : all_)
        if (each.hasWork(samples, known) && (next == nullptr || each.lattice.samples() < next->samples()))
            next = &each.lattice;
    return next;
}

Result<MeasuredBiases> measureBias(const Scene& biased, const Tone& tone, Device& device, double seconds,
                                   const std::stop_token& stop) {
    const auto start = std::chrono::steady_clock::now();
    const auto taken = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
    BiasMeasurements all(biased, biasFacts(biased, {}, device.info().name));
    MeasuredBiases known;
    while (BiasLattice* lattice = all.next(std::numeric_limits<std::uint64_t>::max(), known)) {
        if (stop.stop_requested() || (lattice->samples() > 0 && taken() >= seconds))
            break;
        if (auto ok = lattice->addRound(device, stop); !ok)
            return ok.error();
        known = all.measured(tone);
    }
    return known;
}

}  // namespace pdr
