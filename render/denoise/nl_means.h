#pragma once
/// Non-local means on one scale: every pixel becomes the mean of those around it that look alike as far as noise lets
/// tell (patch_weights.h).

#include "render/denoise/patch_weights.h"

namespace pdr::denoise {

/// Returns the denoised image, which is constant where `image` is, to the bit. Worthless after a stop request.
Colours nonLocalMeans(const NoisyImage& image, const std::stop_token& stop);

}  // namespace pdr::denoise
