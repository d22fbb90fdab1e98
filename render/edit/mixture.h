#pragma once
/// Mixing two images so that the error is least, as two independent halves of samples tell it.

#include "render/film/error/smoothing_judgement.h"

namespace pdr {

/// Returns the share of `first` in the mixture with `second`, [0, 1], whose squared error over the square of
/// 2 kShareRadius + 1 pixels around each pixel is least. What was made of one half of the samples is judged by the
/// other half alone, whose noise it does not know; a half that judged itself would find its own noise to be the truth.
/// `even` and `odd`: both halves as they are. `dim`: radiance below which an error counts as in `dim` itself; above,
/// errors count in parts of the light.
denoise::Plane shareOfFirst(const SmoothHalves& first, const SmoothHalves& second, const denoise::Colours& even,
                            const denoise::Colours& odd, float dim);
inline constexpr int kShareRadius = 12;

/// Returns share * first + (1 - share) * second.
denoise::Colours mixed(const denoise::Plane& share, const denoise::Colours& first, const denoise::Colours& second);

}  // namespace pdr
