#pragma once
/// Shows a coarse image of few samples on a fine guide image that has neither noise nor shadows. The amount of light
/// changes slowly over a surface and is known from the coarse image; the place and the edges of surfaces are known
/// from the guide. So the quotient of both is smoothed and upsampled among pixels of similar surfaces: after joint
/// bilateral upsampling (Kopf et al. 2007). For display during interaction only.

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// The rays of a guide image, one for each of its pixels.
struct GuideRays {
    int finer = 1;     ///< pixels of the guide along each of the film
    vec2 place{0.5f};  ///< where a pixel's ray goes, in parts of its width and height
};

/// A guide image: planes of one size, `finer` times that of the coarse image.
struct Guide {
    int finer = 1;
    Colours radiance;  ///< radiance without shadows, in any unit
    Colours normal;    ///< unit normals, or means of some; 0 where there is nothing
    /// Depth along the view, in units of the width that a coarse pixel has at that depth; 0 where there is nothing.
    Plane depth;
    Plane opacity;  ///< opacity of the visible surface, [0, 1]; 0 where there is nothing
};

Guide guideOf(ivec2 coarseSize, int finer);

/// Returns the coarse image's light on the guide, in the size of the guide. `coarse`: the mean of the samples, without
/// denoising.
Colours guided(const Colours& coarse, const Guide& guide);

}  // namespace pdr::denoise
