#pragma once
/// What an edit changes as far as it can be told without samples: guides of both scenes show what tissue there is and
/// how it is lit, but for shadows. What they do not tell, the first samples do.

#include <optional>

#include "render/edit/first_samples.h"

namespace pdr {

/// Returns the factor by which the light of each pixel changes from the scene of `before` to that of `after`, of films
/// of one size; nothing if a guide of either is missing.
std::optional<denoise::Colours> foretoldGain(const FirstSamples& before, const FirstSamples& after);

/// Returns `image` with that gain, if there is one.
denoise::Colours withGain(const std::optional<denoise::Colours>& gain, const denoise::Colours& image);
/// Returns the same of both halves.
HalfImages withGain(const std::optional<denoise::Colours>& gain, const HalfImages& halves);

}  // namespace pdr
