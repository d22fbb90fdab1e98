#pragma once
/// Visibility weights: how much of the tissue at a position is visible, as a factor of its extinction. Kernels that may
/// have a mask call isMasked() first. The weights are interpolated like HU.

#include "render/kernel/volume_sampling.h"

namespace pdr {

inline constexpr float kPerWeight = 1.0f / kSeen;  // a power of two: the product is not rounded

PDR_HD inline bool isMasked(const FlatScene& scene) {
    return scene.mask.voxels != nullptr;
}

/// Returns the weight at `position` (index space of the volume), in [0, 1]. `scene` must have a mask.
template <class Real>
PDR_HD_INLINE Real weightAt(const FlatScene& scene, const Vec3<Real>& position) {
    const auto node = [](Real place, float last, float nodes) {
        return nodes * min(max(place, Real{}), Real{} + last);
    };
    const vec3 last = scene.volume.lastIndex, nodes = scene.mask.nodesPerVoxel;
    const Vec3<Real> place{node(position.x, last.x, nodes.x), node(position.y, last.y, nodes.y),
                           node(position.z, last.z, nodes.z)};
    return min(trilinearAt(scene.mask, place) * kPerWeight, Real{} + 1.0f);
}

/// Returns the gradient of the weight at `position` (index space) in local space [1/mm], from differences over the
/// distance between two nodes.
PDR_HD inline vec3 weightGradient(const FlatScene& scene, vec3 position) {
    const vec3 halfStep = 0.5f / scene.mask.nodesPerVoxel;
    vec3 perIndex;
    for (int axis = 0; axis < 3; ++axis) {
        vec3 before = position, after = position;
        before[axis] -= halfStep[axis];
        after[axis] += halfStep[axis];
        perIndex[axis] = (weightAt(scene, after) - weightAt(scene, before)) * scene.mask.nodesPerVoxel[axis];
    }
    return glm::transpose(scene.volume.indexFromLocal) * perIndex;
}

}  // namespace pdr
