#pragma once
/// The volume between its voxels: trilinear interpolation, borders clamped. In float, but for the function of single
/// places where the volume has a texture: that one is filtered as texture units do.

#include "render/kernel/texture.h"
#include "render/kernel/voxel_cell.h"

namespace pdr {

/// HU at `position` (index space), exactly. Lanes for volumes as cellAt() of lanes reads them.
template <class Real>
PDR_HD_INLINE Real trilinearAt(const FlatGrid& volume, const Vec3<Real>& position) {
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

}  // namespace pdr
