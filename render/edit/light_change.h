#pragma once
/// How the light of an image changes by an edit: pixel by pixel and channel by channel, light becomes
/// gain * light + offset, at least 0. The change is smooth where the image is not, so it may be known from images of
/// fewer pixels than the one that it is laid on.

#include "render/denoise/plane.h"

namespace pdr {

struct LightChange {
    denoise::Colours gain, offset;
};

/// Returns `factor` times the image.
denoise::Colours scaled(const denoise::Colours& image, float factor);

/// Returns the radiance below which the light of an image is too little to form a quotient.
float dimOf(const denoise::Colours& image);

/// Returns the quotient after / before of images without noise, within limits, beyond which light is not the same light
/// any more. `dim`: see dimOf().
denoise::Colours gainBetween(const denoise::Colours& before, const denoise::Colours& after, float dim);

/// Returns gain * image.
denoise::Colours product(const denoise::Colours& gain, const denoise::Colours& image);

/// Returns the change from `before` to `after`, images without noise. `dim`: see dimOf().
LightChange changeBetween(const denoise::Colours& before, const denoise::Colours& after, float dim);

/// Returns the change in parts of 1 - share, and for the rest the image `fresh` whatever the light was.
LightChange mixed(const denoise::Plane& share, const LightChange& change, const denoise::Colours& fresh);

/// Returns that part of the change.
LightChange partOf(const LightChange& change, const denoise::Plane& share);

/// Returns `old` with the change, which is enlarged to its size.
denoise::Colours laidOn(const denoise::Colours& old, const LightChange& change);

}  // namespace pdr
