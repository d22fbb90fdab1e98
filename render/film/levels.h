#pragma once
/// Maps the radiance of one channel to its level by the radiances at which levels begin; the same on every device.

#include <array>
#include <cstdint>

#include "render/base/portable.h"
#include "render/film/tone_curve.h"

namespace pdr {

/// Thresholds of the levels: entry k is the radiance, in units of the exposure, from which level k + 1 is shown;
/// ascending.
inline constexpr int kThresholds = 255;
using Thresholds = std::array<double, kThresholds>;

/// Returns the thresholds of the curve of tone_map.h.
const Thresholds& displayThresholds();

/// Returns the level of `radiance`: 0 for what is not above 0. `thresholds`: kThresholds of them.
PDR_HD inline std::uint8_t levelOf(const double* thresholds, double radiance, double exposure) {
    if (!(radiance > 0))
        return 0;
    const double fraction = radiance / exposure;
    int level = 0;
    for (int step = (kThresholds + 1) / 2; step > 0; step /= 2)
        if (thresholds[level + step - 1] <= fraction)
            level += step;
    return std::uint8_t(level);
}

/// Returns the level of `fraction`, a radiance in units of the exposure, as levelOf() does but without its search:
/// `curve`, displayCurve(), gives the level or its neighbour.
PDR_HD inline std::uint8_t levelNear(const double* thresholds, const float* curve, double fraction) {
    if (!(fraction > 0))
        return 0;
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): the thresholds decide
    int level = int(exactLevelOf(curve, float(fraction)) + 0.5f);
    while (level < kThresholds && thresholds[level] <= fraction)
        ++level;
    while (level > 0 && thresholds[level - 1] > fraction)
        --level;
    return std::uint8_t(level);
}

}  // namespace pdr
