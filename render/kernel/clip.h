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

/// A plane nearby that cuts.
struct CutFace {
    vec3 normal;        ///< index space, of any length: to where it cuts away
    vec3 foot;          ///< index space: the nearest point on the plane
    float voxelMm = 0;  ///< size of a voxel across the plane; 0: there is none nearby
};

/// The nearest plane that is less than a voxel away from `position` (index space).
PDR_HD inline CutFace cutFaceNear(const FlatClip& clip, vec3 position) {
    CutFace face{};
    float nearest = 1;  // voxel
    for (int i = 0; i < clip.count; ++i) {
        const FlatPlane& plane = clip.planes[i];
        const float room = plane.offset - glm::dot(plane.normal, position);
        const float voxelMm = glm::length(plane.normal);
        if (room >= nearest * voxelMm)
            continue;
        nearest = room / voxelMm;
        face = {plane.normal, position + plane.normal * (room / (voxelMm * voxelMm)), voxelMm};
    }
    return face;
}

}  // namespace pdr
