#pragma once
/// The areas of polygons and ellipses in a plane [mm^2].

#include "render/base/result.h"
#include "render/measure/stated.h"

namespace pdr::measure {

/// Returns the area of the polygon over `corners`, in order, as it appears in the plane with the unit normal `normal`.
/// It is "at most" where it is less than three standard deviations. Fails for fewer than three corners, and where the
/// outline crosses itself, since an area that counts some parts against others measures nothing.
Result<Stated> polygonArea(std::span<const Place> corners, dvec3 normal);

/// Returns the area of the ellipse about `middle` through `end` of one half axis, whose other half axis reaches as far
/// from the first as `other`. It is "at most" by the rule of polygonArea(). Fails if the three lie on one line.
Result<Stated> ellipseArea(const Place& middle, const Place& end, const Place& other);

}  // namespace pdr::measure
