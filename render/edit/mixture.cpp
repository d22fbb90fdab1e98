#include "render/edit/mixture.h"

#include <algorithm>

namespace pdr {
namespace {

using denoise::combined;
using denoise::Plane;

constexpr int kRadius = 12;  ///< radius of the square [pixels]
/// Squared standard deviations that are subtracted from what the halves tell: below them nothing is mixed.
constexpr float kSure = 9;
/// Radius of the box that smooths a change, twice, before the halves are compared [pixels]: single pixels agree on less
/// than surfaces do, and what the eye sees of an edit is surfaces.
constexpr int kSurface = 8;

/// Returns the sum over the channels of (second - first) * (judge - first), by `importance`.
Plane agreementOf(const denoise::Colours& first, const denoise::Colours& second, const denoise::Colours& judge,
                  const Plane& importance) {
    Plane sum(importance.size());
    for (std::size_t c = 0; c < 3; ++c)
        sum = combined(
            [](float so_far, float a, float b, float raw, float i) { return so_far + i * (b - a) * (raw - a); }, sum,
            first[c], second[c], judge[c], importance);
    return sum;
}

Plane changeOfSurfaces(const Plane& from, const Plane& to) {
    const Plane change = combined([](float a, float b) { return b - a; }, from, to);
    return denoise::boxed(denoise::boxed(change, kSurface), kSurface);
}

Plane sumOf(const Plane& a, const Plane& b) {
    return combined([](float x, float y) { return x + y; }, a, b);
}

}  // namespace

Plane shareOfSecond(const SmoothHalves& first, const SmoothHalves& second, const denoise::Colours& even,
                    const denoise::Colours& odd, float dim, float alike) {
    const Plane importance = combined(
        [dim](float a, float b, float c, float d) {
            const float light = (a + b + c + d) / 4 + dim;
            return 1 / (light * light);
        },
        denoise::luminance(first.even), denoise::luminance(first.odd), denoise::luminance(second.even),
        denoise::luminance(second.odd));
    // What each half says of the other, on which they agree but for their noise
    const Plane ofEven = agreementOf(first.even, second.even, odd, importance);
    const Plane ofOdd = agreementOf(first.odd, second.odd, even, importance);
    const Plane agreement = sumOf(ofEven, ofOdd);
    const Plane noise = combined([](float a, float b) { return (a - b) * (a - b); }, ofEven, ofOdd);
    const Plane apart = sumOf(agreementOf(first.even, second.even, second.even, importance),
                              agreementOf(first.odd, second.odd, second.odd, importance));
    // The noise of the mean over the square is that of its pixels over their number
    const ivec2 square = glm::min(ivec2(2 * kRadius + 1), importance.size());
    const auto pixels = float(square.x * square.y);
    const auto share = [alike, pixels](float agreeing, float variance, float whole) {
        if (agreeing <= 0 || whole <= 0)
            return 0.0f;
        return std::min(agreeing / whole, 1.0f) *
               std::max(1 - kSure * alike * variance / (pixels * agreeing * agreeing), 0.0f);
    };
    return combined(share, denoise::boxed(agreement, kRadius), denoise::boxed(noise, kRadius),
                    denoise::boxed(apart, kRadius));
}

Plane shareOfChange(const SmoothHalves& old, const SmoothHalves& laid, float dim) {
    const Plane importance = combined(
        [dim](float a, float b) {
            const float light = (a + b) / 2 + dim;
            return 1 / (light * light);
        },
        denoise::luminance(old.even), denoise::luminance(old.odd));
    Plane agreement(importance.size()), apart = agreement;
    for (std::size_t c = 0; c < 3; ++c) {
        const Plane even = changeOfSurfaces(old.even[c], laid.even[c]);
        const Plane odd = changeOfSurfaces(old.odd[c], laid.odd[c]);
        agreement = combined([](float sum, float i, float a, float b) { return sum + i * a * b; }, agreement,
                             importance, even, odd);
        apart = combined([](float sum, float i, float a, float b) { return sum + i * (a + b) * (a + b) / 4; }, apart,
                         importance, even, odd);
    }
    return combined([](float agreeing, float all) { return agreeing > 0 ? std::min(agreeing / all, 1.0f) : 0; },
                    denoise::boxed(agreement, kRadius), denoise::boxed(apart, kRadius));
}

denoise::Colours mixed(const Plane& share, const denoise::Colours& first, const denoise::Colours& second) {
    denoise::Colours out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = combined([](float s, float a, float b) { return a + s * (b - a); }, share, first[c], second[c]);
    return out;
}

}  // namespace pdr
