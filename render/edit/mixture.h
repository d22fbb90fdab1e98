#pragma once
/// Mixing an image that is probably good with one that is certain, as two independent halves of samples tell how.

#include "render/film/error/smoothing_judgement.h"

namespace pdr {

/// Returns the share of `second` in the mixture with `first`, [0, 1], whose squared error over a square of pixels
/// around each is least; less where that is not sure, and 0 where it could be chance (the positive-part estimator of
/// James & Stein 1961). What was made of one half of the samples is judged by the other half alone, whose noise it does
/// not know; a half that judged itself would find its own noise to be the truth. `even` and `odd`: both halves as they
/// are. `dim`: radiance below which an error counts as in `dim` itself; above, errors count in parts of the light of
/// `first`.
/// `alike`: pixels of a half that share their noise; 1: each has its own.
denoise::Plane shareOfSecond(const SmoothHalves& first, const SmoothHalves& second, const denoise::Colours& even,
                             const denoise::Colours& odd, float dim, float alike = 1);

/// Returns the part of the change from `old` to `laid` whose squared error, over surfaces in a square around each
/// pixel, is least, [0, 1]: what both halves of the samples agree on is the change, the rest is chance (a Wiener
/// filter). `dim`: as above, of `old`.
denoise::Plane shareOfChange(const SmoothHalves& old, const SmoothHalves& laid, float dim);

/// Returns first + share * (second - first).
denoise::Colours mixed(const denoise::Plane& share, const denoise::Colours& first, const denoise::Colours& second);

}  // namespace pdr
