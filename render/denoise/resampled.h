#pragma once
/// Planes in another size. Images of one view share their edges, whatever their numbers of pixels.

#include <vector>

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// Returns the plane in a size that is nowhere larger: each pixel is the mean of its part of the plane, to whole
/// pixels.
Plane reduced(const Plane& plane, ivec2 size);
/// Returns the plane in a size that is nowhere smaller, with bilinear interpolation.
Plane enlarged(const Plane& plane, ivec2 size);

/// Computes the rows of enlarged() one by one, for images that need them once.
class EnlargedRows {
  public:
    /// For planes of `few` pixels, enlarged to `size`.
    EnlargedRows(ivec2 few, ivec2 size);
    /// Returns row `y` of the enlarged plane: its own pixels if the size is the same, else `to`, which holds a row.
    const float* row(const Plane& plane, int y, float* to) const;

  private:
    /// The place of a pixel's centre on a line of fewer pixels.
    struct Place {
        int near;    ///< pixel whose centre is the last before it; -1: none
        float part;  ///< way from there to the next centre, [0, 1)
    };

    static Place placeOf(int i, int few, int many);

    ivec2 few_, size_;
    std::vector<Place> across_;
};

}  // namespace pdr::denoise
