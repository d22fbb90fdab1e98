#include "render/edit/foretold.h"

#include "render/edit/light_change.h"

namespace pdr {

std::optional<denoise::Colours> foretoldGain(const FirstSamples& before, const FirstSamples& after) {
    const auto was = before.unshadowed(), is = after.unshadowed();
    if (!was || !is)
        return std::nullopt;
    return gainBetween(*was, *is, dimOf(*was));
}

denoise::Colours withGain(const std::optional<denoise::Colours>& gain, const denoise::Colours& image) {
    return gain ? product(*gain, image) : image;
}

HalfImages withGain(const std::optional<denoise::Colours>& gain, const HalfImages& halves) {
    return {withGain(gain, halves.even), withGain(gain, halves.odd)};
}

}  // namespace pdr
