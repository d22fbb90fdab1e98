#pragma once
/// How far single pixels are off, as their neighbourhood knows. A pixel that has not yet found a rare light thinks too
/// well of itself: in forward-scattering fog two of its own standard errors hold the truth in 41 % of pixels (64
/// samples), two of these in 97 %.

#include "render/film/error/error_planes.h"

namespace pdr {

inline constexpr int kLocalRadius = 2;

/// Standard errors of the pixels' means, a plane for each channel: the greater of a pixel's own and the root mean
/// square of those in 5 x 5 pixels around it. Infinite: not known, below 2 samples and where less than two bright
/// samples could make all that light around it; 0 where chance has no part.
denoise::Colours localErrors(const Film& film);
/// Of the pixels in `planes`; but to kLocalRadius from its edges they do not know all of their neighbourhood.
denoise::Colours localErrors(const ErrorPlanes& planes);

}  // namespace pdr
