#pragma once
/// The difference between what a display shows and what it would show without noise: |f(m + d) - f(m)| with the tone
/// curve f, a mean m and a draw d of its error (errorDrawOf), clipped to what a display can show. Not f'(m) d: the
/// curve is steep in the dark, where that would be wrong by tens of levels. The same numbers on every device.

#include <cmath>
#include <cstdint>

#include "render/film/moments.h"
#include "render/film/tone_curve.h"

namespace pdr {

/// Returns the error of one channel in levels; `mean` and `draw` are in units of the exposure.
PDR_HD inline float levelsOff(const float* curve, float mean, float draw) {
    const float shown = exactLevelOf(curve, mean), other = exactLevelOf(curve, mean + draw);
    return glm::max(shown - other, other - shown);
}

/// Returns the error of a pixel's worst channel in levels; `mean` and `draw` are linear radiance.
PDR_HD inline float levelsOff(const float* curve, dvec3 mean, dvec3 draw, double exposure) {
    const vec3 shownMean(mean / exposure), shownDraw(draw / exposure);
    float worst = 0;
    for (int channel = 0; channel < 3; ++channel)
        worst = glm::max(worst, levelsOff(curve, shownMean[channel], shownDraw[channel]));
    return worst;
}

/// The bins in which errors are counted are equally wide in the square root of the error: 1/16 level wide at 1 level,
/// 1/4 at 16.
inline constexpr int kErrorBins = 512, kErrorBinsPerRoot = 32;

PDR_HD inline int errorBinOf(float levels) {
    return glm::min(int(float(kErrorBinsPerRoot) * std::sqrt(levels)), kErrorBins - 1);
}

/// Returns the lower edge of a bin [levels].
inline double errorBinBegin(int bin) {
    return double(bin) * bin / (double(kErrorBinsPerRoot) * kErrorBinsPerRoot);
}

/// A histogram of the errors of an image's pixels.
struct ErrorCounts {
    std::uint32_t pixels[kErrorBins] = {};

    void add(const ErrorCounts& other) {
        for (int bin = 0; bin < kErrorBins; ++bin)
            pixels[bin] += other.pixels[bin];
    }
};

/// Returns the error [levels] that `fraction` of the pixels do not exceed, evenly spread inside a bin; 0 without
/// pixels.
double errorQuantile(const ErrorCounts& counts, double fraction);

}  // namespace pdr
