#include "render/denoise/smoothing.h"

#include <algorithm>

#include "render/denoise/nl_means.h"
#include "render/denoise/regained.h"

namespace pdr::denoise {
namespace {

constexpr int kScales = 4, kSmallest = 16;  ///< scales; shorter edge [pixels] below which there is no coarser one
constexpr int kVarianceRadius = 2, kRatioRadius = 10;
constexpr float kMostRatio = 2, kLeastVariance = 1e-6f, kTiny = 1e-9f;

/// Denoises on several scales: the coarser scale replaces the low frequencies of this one.
Colours onScales(const NoisyImage& image, int scales, const std::stop_token& stop) {
    Colours fine = nonLocalMeans(image, stop);
    const ivec2 size = image.luminance.size();
    if (scales <= 1 || stop.stop_requested() || std::min(size.x, size.y) < kSmallest)
        return fine;
    const Colours& mean = image.mean;
    const Colours half{halved(mean[0], 0.25f), halved(mean[1], 0.25f), halved(mean[2], 0.25f)};
    const Colours coarse =
        onScales({half, halved(image.luminance, 0.25f), halved(image.variance, 0.0625f)}, scales - 1, stop);
    for (int c = 0; c < 3; ++c)
        addDoubled(combined([](float better, float here) { return better - here; }, coarse[c], halved(fine[c], 0.25f)),
                   fine[c]);
    return fine;
}

}  // namespace

Plane noiseRatio(const Plane& differences, const Plane& presumed) {
    const Plane real = combined([](float difference) { return difference * difference; }, differences);
    return combined([](float is, float said) { return std::min(kMostRatio, is / (said + kTiny)); },
                    boxed(real, kRatioRadius), boxed(presumed, kRatioRadius));
}

Plane varianceAround(const Plane& luminance) {
    constexpr float kPixels = (2 * kVarianceRadius + 1) * (2 * kVarianceRadius + 1);
    const Plane squares = combined([](float value) { return value * value; }, luminance);
    return combined(
        [](float square, float mean) { return std::max(0.0f, square - mean * mean) * (kPixels / (kPixels - 1)); },
        boxed(squares, kVarianceRadius), boxed(luminance, kVarianceRadius));
}

Plane realVariance(const Plane& variance, const Plane& ratio) {
    return combined([](float presumed, float r) { return presumed * r; }, boxed(variance, kVarianceRadius), ratio);
}

Colours denoised(const Colours& mean, const Plane& variance, const Plane& ratio, const std::stop_token& stop,
                 const Features* features) {
    const Plane noise = realVariance(variance, ratio);
    const Plane counted = combined([](float real) { return real + kLeastVariance; }, noise);
    const Plane light = luminance(mean);
    const NoisyImage image{mean, light, counted};
    Colours out = features != nullptr ? regressed(image, *features, stop) : onScales(image, kScales, stop);
    if (stop.stop_requested())
        return out;
    regain(mean, noise, out, stop);
    for (int c = 0; c < 3; ++c)
        out[c] = combined([](float smooth, float raw, float real) { return real == 0 ? raw : std::max(smooth, 0.0f); },
                          out[c], mean[c], noise);
    return out;
}

}  // namespace pdr::denoise
