#pragma once
/// The volume between its voxels: trilinear interpolation, borders clamped, and its gradient. In float, but for the
/// function of single places where the volume has a texture: that one is filtered as texture units do.

#include "render/kernel/texture.h"
#include "render/kernel/voxel_cell.h"

namespace pdr {

/// HU at `position` (index space), exactly. Lanes for volumes as cellAt() of lanes reads them.
template <class Real>
PDR_HD_INLINE Real trilinearAt(const FlatVolume& volume, const Vec3<Real>& position) {
    const auto clamped = [](Real value, float high) { return min(max(value, Real{}), Real{} + high); };
    const Real x = clamped(position.x, volume.lastIndex.x);
    const Real y = clamped(position.y, volume.lastIndex.y);
    const Real z = clamped(position.z, volume.lastIndex.z);
    // At the last voxel the cell before it is used, with fraction 1.
    const auto corner = [](Real value, float last) { return toInt(min(value, Real{} + last)); };
    const Vec3<typename SimdTraits<Real>::Int> lowest{corner(x, volume.lastCorner.x), corner(y, volume.lastCorner.y),
                                                      corner(z, volume.lastCorner.z)};
    const VoxelCell<Real> cell = cellAt(volume, lowest);
    return trilinear(cell, {x - cell.lowest.x, y - cell.lowest.y, z - cell.lowest.z});
}

PDR_HD inline float interpolatedHounsfield(const FlatVolume& volume, vec3 position) {
    return trilinearAt<float>(volume, {position.x, position.y, position.z});
}

/// The same, or as texture units filter it where the volume has a texture.
PDR_HD inline float hounsfield(const FlatVolume& volume, vec3 position) {
    if (volume.texture != 0) [[unlikely]]  // on the CPU
        return textureHounsfield(volume, position);
    return interpolatedHounsfield(volume, position);
}

PDR_HD inline float hounsfield(const FlatVolume& volume, const Vec3<float>& position) {
    return hounsfield(volume, vec3(position.x, position.y, position.z));
}

#if !defined(__CUDACC__)

/// The same in step, bit by bit.
PDR_HD_INLINE FloatLanes hounsfield(const FlatVolume& volume, const Vec3<FloatLanes>& position) {
    return trilinearAt(volume, position);
}

#endif

/// Local position [mm] of an index-space position.
PDR_HD inline vec3 localPosition(const FlatVolume& volume, vec3 position) {
    return volume.localFromIndex * (position - 0.5f * volume.lastIndex);
}

/// The gradient of what read(position) returns [HU].
template <class Read>
PDR_HD inline vec3 gradientOf(const FlatVolume& volume, vec3 position, Read&& read) {
    const auto difference = [&](vec3 offset) { return 0.5f * (read(position + offset) - read(position - offset)); };
    const vec3 perIndex(difference({1, 0, 0}), difference({0, 1, 0}), difference({0, 0, 1}));
    return glm::transpose(volume.indexFromLocal) * perIndex;
}

/// Gradient of the HU in local space [HU/mm], by central differences over one voxel to each side.
PDR_HD inline vec3 hounsfieldGradient(const FlatVolume& volume, vec3 position) {
    if (volume.texture != 0) [[unlikely]]  // asked once: on the CPU, six times would be felt
        return gradientOf(volume, position, [&](vec3 place) { return textureHounsfield(volume, place); });
    return gradientOf(volume, position, [&](vec3 place) { return interpolatedHounsfield(volume, place); });
}

}  // namespace pdr
