#pragma once
/// What is cut away: all beyond any of some planes. What stays is convex, so a ray is clipped by shortening it.

#include "render/kernel/flat_scene.h"
#include "render/kernel/ray.h"

namespace pdr {

/// The part of a ray (index space) that no plane cuts away.
template <class Number>
PDR_HD_INLINE Interval<Number> cut(const FlatClip& clip, glm::vec<3, Number> origin, glm::vec<3, Number> direction,
                                   Interval<Number> inside) {
    for (int i = 0; i < clip.count; ++i) {
        const glm::vec<3, Number> normal(clip.planes[i].normal);
        const Number room = Number(clip.planes[i].offset) - glm::dot(normal, origin);
        const Number closing = glm::dot(normal, direction);
        if (closing > 0)
            inside.leave = glm::min(inside.leave, room / closing);
        else if (closing < 0)
            inside.enter = glm::max(inside.enter, room / closing);
        else if (room < 0)
            inside.leave = -1;
    }
    return inside;
}

/// How much of a ray that starts where nothing is cut away stays there [mm].
PDR_HD inline float cutLength(const FlatClip& clip, vec3 origin, vec3 direction, float length) {
    return cut(clip, origin, direction, Interval<float>{0, length}).leave;
}

}  // namespace pdr
