#include "render/edit/light_change.h"

#include <algorithm>

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

Plane inSize(const Plane& plane, ivec2 size) {
    return plane.size() == size ? plane : denoise::enlarged(plane, size);
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
    denoise::Colours out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = combined([](float light, float gain, float offset) { return std::max(gain * light + offset, 0.0f); },
                          old[c], inSize(change.gain[c], old[c].size()), inSize(change.offset[c], old[c].size()));
    return out;
}

}  // namespace pdr
