#pragma once
/// A smoothed picture for the eye: non-local means on four scales, steered by luminance alone. It takes noise away and
/// with it detail that the noise hides, so what is smoothed is never measured, and is always shown with its error.
///   noise ratio   by how much the noise really differs from what independent samples would have: two halves of the
///                 samples tell, as they are around each pixel. Without it pictures of stratified samples are blurred

#include "render/denoise/nl_means.h"

namespace pdr::denoise {

/// Real over presumed variance in 21 x 21 pixels, at most 2. `differences`: between the luminances of two independent
/// estimates; `presumed`: the variance that these should have.
Plane noiseRatio(const Plane& differences, const Plane& presumed);

/// The variance of a picture's luminance as its neighbours tell it, where nothing else is known: edges count as noise.
Plane varianceAround(const Plane& luminance);

/// The real variance of a picture's luminance, averaged over 5 x 5 pixels. `variance`: the presumed one.
Plane realVariance(const Plane& variance, const Plane& ratio);

/// `mean` without its noise, never below 0. `variance`: presumed for its luminance; where the real one is 0 the picture
/// stays as it is. Radiances should be about 1: less than 0.1 % of that counts as noise. After a stop request it is
/// worthless.
Colours smoothed(const Colours& mean, const Plane& variance, const Plane& ratio, const std::stop_token& stop = {});

}  // namespace pdr::denoise
