#pragma once
/// Restores fine detail that denoising removed though the noisy image shows it: what was removed adds up, along a short
/// line, to more than noise is likely to. A small vessel, short or bent, consists of many such lines.
///   line      9 pixels long and 2 wide, in one of 16 directions; each pixel has 32 of them, of which the clearest
///             counts
///   put back  the mean of what was removed along the line, so that a vessel comes back without its noise

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// Adds to `smooth` what it has lost of `raw`. Where no line is clear `smooth` stays as it is, to the bit; it never
/// becomes negative. `variance`: of the noise in the luminance of `raw`, independent from pixel to pixel; where it is 0
/// there is no noise, and nothing was lost. Worthless after a stop request.
void regain(const Colours& raw, const Plane& variance, Colours& smooth, const std::stop_token& stop = {});

}  // namespace pdr::denoise
