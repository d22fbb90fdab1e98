#pragma once
/// The denoiser: non-local means on four scales, steered by luminance alone, or, where features of the image are known,
/// regression on them. It removes noise and with it detail that the noise hides, so a denoised image is never measured,
/// and is always shown with its error.
///   noise ratio   real variance over that of independent samples, estimated around each pixel from the two
///                 halves of the samples. Without it images of stratified samples are blurred

#include "render/denoise/regression.h"

namespace pdr::denoise {

/// Returns the real over the presumed variance in 21 x 21 pixels, at most 2. `differences`: between the luminances of
/// two independent estimates; `presumed`: the variance that these should have.
Plane noiseRatio(const Plane& differences, const Plane& presumed);

/// Returns the variance of an image's luminance estimated from neighbours, where nothing else is known: edges count as
/// noise.
Plane varianceAround(const Plane& luminance);

/// Returns the real variance of an image's luminance, averaged over 5 x 5 pixels. `variance`: the presumed one.
Plane realVariance(const Plane& variance, const Plane& ratio);

/// Returns `mean` denoised, never below 0. `variance`: presumed for its luminance; where the real one is 0 the image
/// stays as it is. Radiances should be about 1: less than 0.1 % of that counts as noise. Worthless after a stop
/// request. `features`: of the same image; null: none are known.
Colours denoised(const Colours& mean, const Plane& variance, const Plane& ratio, const std::stop_token& stop = {},
                 const Features* features = nullptr);

}  // namespace pdr::denoise
