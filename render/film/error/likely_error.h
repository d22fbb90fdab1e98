#pragma once
/// How far single pixels are likely to be off: standard errors, of which 1.96 to either side hold the truth in 94 to 97
/// % of the tissue (tests/bench/stated_coverage), where localErrors() is a bound. Low-discrepancy points are 1.2 to 30
/// times better than the independent samples that a bound presumes; how much, only the halves of the samples tell.

#include "render/denoise/plane.h"
#include "render/film/film.h"

namespace pdr {

/// Standard errors of the means of the pixels in `part` of the film, at least one, a plane for each channel:
/// localErrors() times what the noise in 13 x 13 pixels around, as the draws of their errors tell it (errorDrawOf()),
/// is to what is presumed of it. Never more than localErrors(); infinite and 0 where those are.
denoise::Colours likelyErrors(const Film& film, const Tile& part);

}  // namespace pdr
