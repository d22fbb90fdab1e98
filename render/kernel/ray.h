#pragma once
/// A ray inside the volume's box, ready for walking cells.

#include "render/base/portable.h"

namespace pdr {

/// origin + direction * t, index space, t in mm from the origin, 0 <= t <= length. The origin lies at the box's border
/// or inside, so that single precision is fine grained wherever the camera stands.
struct Ray {
    vec3 origin;
    vec3 direction;  ///< index steps per mm
    float length;    ///< mm; <= 0: the ray misses the box
};

/// The part of a ray inside the box [low, high], at t in [enter, leave]; empty (enter > leave) where it misses. A
/// direction component of 0 is parallel to its slab: it bounds nothing when the origin lies inside and everything when
/// it does not. Closed at the lower border. Number: float or double.
template <class Number>
struct Interval {
    Number enter, leave;
};

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
