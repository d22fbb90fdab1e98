#pragma once
/// How far what a display shows may be from what it would show without noise: [f(m - 2 s), f(m + 2 s)] around f(m),
/// with the tone curve f, a mean m and its standard error s, clipped to what a display can show. Two-sided, since the
/// curve is steep in the dark: f'(m) s would be wrong by tens of levels there. The same numbers on every device.

#include <cmath>
#include <cstdint>

#include "render/film/moments.h"
#include "render/film/tone_curve.h"

namespace pdr {

/// The farther end of a channel's interval, in levels; mean and standard error in units of the exposure. The curve is
/// concave: unless the interval reaches below black, the lower end is the farther one.
PDR_HD inline float levelsOff(const float* curve, float mean, float standardError) {
    if (!(standardError > 0))
        return 0;
    const float shown = exactLevelOf(curve, mean), off = 2 * standardError;
    if (mean >= off)
        return shown - exactLevelOf(curve, mean - off);
    return glm::max(shown, exactLevelOf(curve, mean + off) - shown);
}

/// Of the worst channel of a pixel, in linear radiance.
PDR_HD inline float levelsOff(const float* curve, dvec3 mean, dvec3 standardError, double exposure) {
    const vec3 shownMean(mean / exposure), shownError(standardError / exposure);
    float worst = 0;
    for (int channel = 0; channel < 3; ++channel)
        worst = glm::max(worst, levelsOff(curve, shownMean[channel], shownError[channel]));
    return worst;
}

/// Errors are counted in bins that are even in their square root: 1/16 level wide at 1 level, 1/4 at 16.
inline constexpr int kErrorBins = 512, kErrorBinsPerRoot = 32;

PDR_HD inline int errorBinOf(float levels) {
    return glm::min(int(float(kErrorBinsPerRoot) * std::sqrt(levels)), kErrorBins - 1);
}

/// Where a bin begins [levels].
inline double errorBinBegin(int bin) {
    return double(bin) * bin / (double(kErrorBinsPerRoot) * kErrorBinsPerRoot);
}

/// How many pixels of an image have which error.
struct ErrorCounts {
    std::uint32_t pixels[kErrorBins] = {};

    void add(const ErrorCounts& other) {
        for (int bin = 0; bin < kErrorBins; ++bin)
            pixels[bin] += other.pixels[bin];
    }
};

/// The error [levels] that `fraction` of the pixels do not exceed, evenly spread inside a bin; 0 without pixels.
double errorQuantile(const ErrorCounts& counts, double fraction);

}  // namespace pdr
