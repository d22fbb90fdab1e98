#pragma once
/// Planes in another size. Images of one view share their edges, whatever their numbers of pixels.

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// Returns the plane in a size that is nowhere larger: each pixel is the mean of its part of the plane, to whole
/// pixels.
Plane reduced(const Plane& plane, ivec2 size);
/// Returns the plane in a size that is nowhere smaller, with bilinear interpolation.
Plane enlarged(const Plane& plane, ivec2 size);

}  // namespace pdr::denoise
