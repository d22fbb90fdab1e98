#pragma once
/// Slices of half the resolution, which take a quarter of the time, for views in which something moves.

#include "render/slice/slice_plane.h"

namespace pdr {

/// Returns the plane whose pixels cover two by two of `plane`'s each, from the upper left corner on. Where a size of
/// `plane` is odd, the last pixel reaches beyond it by half.
inline SlicePlane halved(const SlicePlane& plane) {
    SlicePlane half = plane;
    half.originMm = plane.mmAt({0.5, 0.5});
    half.mmPerPixel = 2 * plane.mmPerPixel;
    half.size = (plane.size + 1) / 2;
    return half;
}

}  // namespace pdr
