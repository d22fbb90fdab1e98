#pragma once
/// A coarse picture of few samples, drawn on a fine one that has neither noise nor shadows. How much light comes
/// changes slowly over a surface and is known from the coarse picture; where surfaces lie and end is known from the
/// guide. So the quotient of both is smoothed and made finer, among what is alike: after joint bilateral upsampling
/// (Kopf et al. 2007). For the eye only, while something moves.

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// Planes of one size, `finer` times that of the coarse picture.
struct Guide {
    int finer = 1;
    Colours radiance;  ///< as if nothing stood in the light's way; in any unit
    Colours normal;    ///< unit vectors, or means of some; 0 where there is nothing
    Plane depth;       ///< along the view, 1 for each pixel of the coarse picture as wide as it is there; 0 likewise
    Plane opacity;     ///< of what is seen, [0, 1]; 0 where there is nothing
};

Guide guideOf(ivec2 coarseSize, int finer);

/// The coarse picture's light on the guide: as large as the guide. `coarse`: the mean of the samples, noise and all.
Colours guided(const Colours& coarse, const Guide& guide);

}  // namespace pdr::denoise
