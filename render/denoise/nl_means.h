#pragma once
/// Non-local means on one scale: every pixel becomes the mean of those around it whose 5 x 5 patches of luminance
/// differ by no more than the noise explains. After Buades, Coll & Morel 2005; the distance less the noise is that of
/// Rousselle, Knaus & Zwicker 2012.

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// An image and its noise: all planes of one size, which others own.
struct NoisyPicture {
    const Colours& mean;
    const Plane& luminance;  ///< of the mean
    const Plane& variance;   ///< of that luminance; > 0, in images whose radiances are about 1
};

/// Stays constant where `picture` is, to the bit. After a stop request it is worthless.
Colours nonLocalMeans(const NoisyPicture& picture, const std::stop_token& stop);

}  // namespace pdr::denoise
