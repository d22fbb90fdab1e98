#include "render/edit/mixture.h"

#include <algorithm>

namespace pdr {
namespace {

using denoise::combined;
using denoise::Plane;

/// Returns the sum over the channels of a and b: products of differences, in parts of the light.
Plane agreementOf(const denoise::Colours& first, const denoise::Colours& second, const denoise::Colours& judge,
                  const Plane& importance) {
    Plane sum(importance.size());
    for (std::size_t c = 0; c < 3; ++c)
        sum = combined(
            [](float so_far, float a, float b, float raw, float i) { return so_far + i * (a - b) * (raw - b); }, sum,
            first[c], second[c], judge[c], importance);
    return sum;
}

}  // namespace

Plane shareOfFirst(const SmoothHalves& first, const SmoothHalves& second, const denoise::Colours& even,
                   const denoise::Colours& odd, float dim) {
    const Plane importance = combined(
        [dim](float a, float b) {
            const float light = (a + b) / 2 + dim;
            return 1 / (light * light);
        },
        denoise::luminance(second.even), denoise::luminance(second.odd));
    const auto add = [](float a, float b) { return a + b; };
    const Plane agreement = combined(add, agreementOf(first.even, second.even, odd, importance),
                                     agreementOf(first.odd, second.odd, even, importance));
    const Plane apart = combined(add, agreementOf(first.even, second.even, first.even, importance),
                                 agreementOf(first.odd, second.odd, first.odd, importance));
    return combined([](float part, float whole) { return whole > 0 ? std::clamp(part / whole, 0.0f, 1.0f) : 1.0f; },
                    denoise::boxed(agreement, kShareRadius), denoise::boxed(apart, kShareRadius));
}

denoise::Colours mixed(const Plane& share, const denoise::Colours& first, const denoise::Colours& second) {
    denoise::Colours out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = combined([](float s, float a, float b) { return b + s * (a - b); }, share, first[c], second[c]);
    return out;
}

}  // namespace pdr
