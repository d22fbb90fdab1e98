#pragma once
/// Non-local means on one scale: every pixel becomes the mean of those around it whose 5 x 5 patches of luminance
/// differ by no more than the noise explains. After Buades, Coll & Morel 2005; subtracting the noise from the distance
/// is after Rousselle, Knaus & Zwicker 2012.

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// An image and its noise: planes of one size, not owned.
struct NoisyImage {
    const Colours& mean;
    const Plane& luminance;  ///< luminance of the mean
    const Plane& variance;   ///< variance of that luminance; > 0, in images whose radiances are about 1
};

/// Returns the denoised image, which is constant where `image` is, to the bit. Worthless after a stop request.
Colours nonLocalMeans(const NoisyImage& image, const std::stop_token& stop);

}  // namespace pdr::denoise
