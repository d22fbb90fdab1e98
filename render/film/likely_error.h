#pragma once
/// How far single pixels are likely to be off. Low-discrepancy points are 1.2 to 2.5 times better than independent
/// samples, which localErrors() presumes, so that these are no bound but an estimate; and as safe where light is rare.

#include "render/denoise/plane.h"
#include "render/film/film.h"

namespace pdr {

/// localErrors() of the pixels in `part` of the film, at least one, times what the noise in 21 x 21 pixels around, as
/// the draws of their errors tell it (errorDrawOf()), is to that of independent samples: never more than that. Infinite
/// and 0 where those are.
denoise::Colours likelyErrors(const Film& film, const Tile& part);

}  // namespace pdr
