#pragma once
/// Rays in the index space of a volume, and their clipping to a box.

#include "render/base/portable.h"

namespace pdr {

/// A ray origin + direction * t in index space, with t in mm from the origin and 0 <= t <= length. The origin lies at
/// the border of the volume's box or inside, so that single precision is accurate wherever the camera stands.
template <class Real>
struct RayOf {
    glm::vec<3, Real> origin;
    glm::vec<3, Real> direction;  ///< index-space step per mm
    Real length;                  ///< mm; <= 0: the ray misses the box
};
using Ray = RayOf<float>;

/// The part of a ray at t in [enter, leave]; empty if enter > leave. Number: float or double.
template <class Number>
struct Interval {
    Number enter, leave;
};

/// Returns the part of `interval` in which a ray is inside the box [low, high]. A direction component of 0 is parallel
/// to its slab: it bounds nothing if the origin lies inside the slab, and empties the interval if it does not. The box
/// is closed at its lower border.
template <class Number>
PDR_HD_INLINE Interval<Number> clipped(glm::vec<3, Number> origin, glm::vec<3, Number> direction,
                                       glm::vec<3, Number> low, glm::vec<3, Number> high, Interval<Number> interval) {
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (!(origin[axis] >= low[axis] && origin[axis] < high[axis]))
                interval = {1, 0};  // and the other axes can only make it emptier
            continue;
        }
        const Number inverse = 1 / direction[axis];
        const Number a = (low[axis] - origin[axis]) * inverse;
        const Number b = (high[axis] - origin[axis]) * inverse;
        interval.enter = glm::max(interval.enter, glm::min(a, b));
        interval.leave = glm::min(interval.leave, glm::max(a, b));
    }
    return interval;
}

}  // namespace pdr
