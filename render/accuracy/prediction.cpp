#include "render/accuracy/prediction.h"

#include <algorithm>
#include <cmath>

namespace pdr {

double samplesToReach(double target, const FilmStatus& status) {
    const double share = status.relativeError / target;
    return double(status.samplesPerPixel) * std::max(share * share, 1.0);
}

std::optional<QualityStep> nextQualityStep(const FilmStatus& status, double samplesPerSecond) {
    if (status.samplesPerPixel < kSamplesToPredict || !(samplesPerSecond > 0) || !std::isfinite(status.relativeError))
        return std::nullopt;
    for (const double step : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001})
        if (step < status.relativeError) {
            const double more = samplesToReach(step, status) - double(status.samplesPerPixel);
            return QualityStep{step, more / samplesPerSecond};
        }
    return std::nullopt;
}

}  // namespace pdr
