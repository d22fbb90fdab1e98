#include "render/edit/light_change.h"

#include <algorithm>
#include <vector>

#include "render/denoise/resampled.h"

namespace pdr {
namespace {

using denoise::combined;
using denoise::Plane;

/// The greatest factor by which light changes as a quotient; what is beyond is added as smooth light, since where the
/// old image was dark, nothing sharp is known.
constexpr float kMostFactor = 4;
/// Part of the mean luminance below which light is too little to form a quotient.
constexpr float kDimPart = 0.02f;

/// Changes the light of `count` pixels.
void lay(const float* light, const float* gain, const float* offset, float* __restrict out, int count) {
    for (int i = 0; i < count; ++i)
        out[i] = std::max(gain[i] * light[i] + offset[i], 0.0f);
}

}  // namespace

denoise::Colours scaled(const denoise::Colours& image, float factor) {
    denoise::Colours out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = combined([factor](float light) { return factor * light; }, image[c]);
    return out;
}

float dimOf(const denoise::Colours& image) {
    return kDimPart * float(denoise::meanOf(denoise::luminance(image)));
}

denoise::Colours gainBetween(const denoise::Colours& before, const denoise::Colours& after, float dim) {
    denoise::Colours gain;
    for (std::size_t c = 0; c < 3; ++c)
        gain[c] = combined(
            [dim](float was, float is) { return std::clamp((is + dim) / (was + dim), 1 / kMostFactor, kMostFactor); },
            before[c], after[c]);
    return gain;
}

denoise::Colours product(const denoise::Colours& gain, const denoise::Colours& image) {
    denoise::Colours out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = combined([](float factor, float light) { return factor * light; }, gain[c], image[c]);
    return out;
}

LightChange changeBetween(const denoise::Colours& before, const denoise::Colours& after, float dim) {
    LightChange change{gainBetween(before, after, dim), {}};
    for (std::size_t c = 0; c < 3; ++c)
        change.offset[c] = combined([](float gain, float was, float is) { return is - gain * was; }, change.gain[c],
                                    before[c], after[c]);
    return change;
}

LightChange mixed(const Plane& share, const LightChange& change, const denoise::Colours& fresh) {
    LightChange out;
    for (std::size_t c = 0; c < 3; ++c) {
        out.gain[c] = combined([](float s, float gain) { return (1 - s) * gain; }, share, change.gain[c]);
        out.offset[c] = combined([](float s, float offset, float light) { return offset + s * (light - offset); },
                                 share, change.offset[c], fresh[c]);
    }
    return out;
}

LightChange partOf(const LightChange& change, const Plane& share) {
    LightChange out;
    for (std::size_t c = 0; c < 3; ++c) {
        out.gain[c] = combined([](float s, float gain) { return 1 + s * (gain - 1); }, share, change.gain[c]);
        out.offset[c] = combined([](float s, float offset) { return s * offset; }, share, change.offset[c]);
    }
    return out;
}

denoise::Colours laidOn(const denoise::Colours& old, const LightChange& change) {
    const ivec2 size = old[0].size();
    const denoise::EnlargedRows rows(change.gain[0].size(), size);
    denoise::Colours out{Plane::unset(size), Plane::unset(size), Plane::unset(size)};
    denoise::eachBand(size.y, {}, [&](int begin, int end) {
        std::vector<float> gains(std::size_t(size.x)), offsets = gains;
        for (int y = begin; y < end; ++y)
            for (std::size_t c = 0; c < 3; ++c)
                lay(old[c].row(y), rows.row(change.gain[c], y, gains.data()),
                    rows.row(change.offset[c], y, offsets.data()), out[c].row(y), size.x);
    });
    for (Plane& plane : out)
        plane.mirror();
    return out;
}

}  // namespace pdr
