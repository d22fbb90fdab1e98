#pragma once
/// Clipping by planes: everything beyond any of the planes is cut away. What remains is convex, so a ray is clipped by
/// shortening it.

#include "render/base/lanes.h"
#include "render/kernel/flat_scene.h"
#include "render/kernel/ray.h"

namespace pdr {

/// Returns the part of a ray (index space) that no plane cuts away.
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

/// Returns the length [mm] up to which a ray stays in the uncut part. The ray must start there.
template <class Real>
PDR_HD inline Real cutLength(const FlatClip& clip, const Vec3<Real>& origin, const Vec3<Real>& direction, Real length) {
    for (int i = 0; i < clip.count; ++i) {
        const vec3 normal = clip.planes[i].normal;
        const Real room = clip.planes[i].offset - dot(normal, origin);
        const Real closing = dot(normal, direction);
        const Real reached = min(room / closing, length);
        const Real parallel = room < 0.0f ? Real{} - 1.0f : length;
        length = closing > 0.0f ? reached : (closing < 0.0f ? length : parallel);
    }
    return length;
}

/// A clip plane near a point.
struct CutFace {
    vec3 normal;        ///< index space, of any length, towards the part that is cut away
    vec3 foot;          ///< nearest point on the plane, index space
    float voxelMm = 0;  ///< size of a voxel across the plane; 0: no plane is near
};

/// Returns the nearest plane that is less than a voxel away from `position` (index space).
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
