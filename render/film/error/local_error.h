#pragma once
/// Bounds on the errors of single pixels, from their neighbourhoods. A pixel that has not yet found a rare light
/// underestimates its error: in forward-scattering fog two of its own standard errors hold the truth in 41 % of pixels
/// (64 samples), two of these in 97 %.

#include "render/film/error/error_planes.h"

namespace pdr {

inline constexpr int kLocalRadius = 2;

/// Returns standard errors of the pixels' means, a plane for each channel: the greater of a pixel's own and the root
/// mean square of those in 5 x 5 pixels around it. Infinite: not known, below 2 samples and where less than two bright
/// samples could make all the light around the pixel; 0 where chance has no part.
denoise::Colours localErrors(const Film& film);
/// Returns the local errors of the pixels in `planes`; within kLocalRadius of the edges the neighbourhoods are
/// incomplete.
denoise::Colours localErrors(const ErrorPlanes& planes);

}  // namespace pdr
