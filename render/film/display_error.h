#pragma once
/// The difference between what a display shows and what it would show without noise: |f(m + d) - f(m)| with the tone
/// curve f, a mean m and a draw d of its error (errorDrawOf), clipped to what a display can show. Not f'(m) d: the
/// curve is steep in the dark, where that would be wrong by tens of levels. The three channels of a draw go through
/// the curve together, since with keepsHue the largest one decides on the others. The same numbers on every device.

#include <cmath>
#include <cstdint>

#include "render/film/display_transform.h"
#include "render/film/moments.h"

namespace pdr {

/// Returns the error of each channel in levels; `mean` and `draw` are in units of the exposure.
PDR_HD inline vec3 channelsOff(const DisplayTransform& transform, vec3 mean, vec3 draw) {
    return glm::abs(transform.exactLevels(mean) - transform.exactLevels(mean + draw));
}

/// Returns the error of a pixel's worst channel in levels; `mean` and `draw` are linear radiance.
PDR_HD inline float levelsOff(const DisplayTransform& transform, dvec3 mean, dvec3 draw) {
    const vec3 off = channelsOff(transform, vec3(mean / transform.exposure), vec3(draw / transform.exposure));
    return glm::max(off.x, glm::max(off.y, off.z));
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
