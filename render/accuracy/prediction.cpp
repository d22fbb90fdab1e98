#include "render/accuracy/prediction.h"

#include <algorithm>
#include <cmath>

namespace pdr {
namespace {

double samplesFor(double target, double error, std::uint64_t samples) {
    const double fraction = error / target;
    return double(samples) * std::max(fraction * fraction, 1.0);
}

}  // namespace

double samplesToReach(double target, const FilmStatus& status) {
    return samplesFor(target, status.relativeError, status.samplesPerPixel);
}

double samplesToReachLevels(double target, const FilmStatus& status) {
    return samplesFor(target, status.displayError, status.samplesPerPixel);
}

std::optional<QualityStep> nextQualityStep(const FilmStatus& status, double samplesPerSecond) {
    if (!(samplesPerSecond > 0) || !std::isfinite(status.displayError))
        return std::nullopt;
    for (const double step : {32.0, 16.0, 8.0, 4.0, 2.0, kFinestStep})
        if (step < status.displayError) {
            const double more = samplesToReachLevels(step, status) - double(status.samplesPerPixel);
            return QualityStep{step, more / samplesPerSecond, status.fewBrightSamples};
        }
    return std::nullopt;
}

}  // namespace pdr
