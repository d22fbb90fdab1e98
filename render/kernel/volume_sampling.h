#pragma once
/// The values of the volume between its voxels: trilinear interpolation with clamped borders. It is computed in float,
/// except that hounsfield() of a single position filters as texture units do if the volume has a texture.

#include "render/kernel/texture.h"
#include "render/kernel/voxel_cell.h"

namespace pdr {

/// Returns the exactly interpolated HU at `position` (index space). For lanes, the volume must be one that cellAt() of
/// lanes can read.
template <class Real>
PDR_HD_INLINE Real trilinearAt(const FlatGrid& volume, const Vec3<Real>& position) {
    const auto clamped = [](Real value, float high) { return min(max(value, Real{}), Real{} + high); };
    const Real x = clamped(position.x, volume.lastIndex.x);
    const Real y = clamped(position.y, volume.lastIndex.y);
    const Real z = clamped(position.z, volume.lastIndex.z);
    // At the last voxel, use the cell before it with fraction 1.
    const auto corner = [](Real value, float last) { return toInt(min(value, Real{} + last)); };
    const Vec3<typename SimdTraits<Real>::Int> lowest{corner(x, volume.lastCorner.x), corner(y, volume.lastCorner.y),
                                                      corner(z, volume.lastCorner.z)};
    const VoxelCell<Real> cell = cellAt(volume, lowest);
    return trilinear(cell, {x - cell.lowest.x, y - cell.lowest.y, z - cell.lowest.z});
}

PDR_HD inline float interpolatedHounsfield(const FlatVolume& volume, vec3 position) {
    return trilinearAt(volume, position);
}

/// Returns the HU at `position` (index space): interpolated exactly, or as texture units do if the volume has a
/// texture.
PDR_HD inline float hounsfield(const FlatVolume& volume, vec3 position) {
    if (volume.texture != 0) [[unlikely]]  // on the CPU
        return textureHounsfield(volume, position);
    return interpolatedHounsfield(volume, position);
}

#if !defined(__CUDACC__)

/// Returns the HU at the position of each lane, bit by bit as interpolatedHounsfield() does.
PDR_HD_INLINE FloatLanes hounsfield(const FlatVolume& volume, const Vec3<FloatLanes>& position) {
    return trilinearAt(volume, position);
}

#endif

/// Returns the local position [mm] of an index-space position.
template <class Real>
PDR_HD inline Vec3<Real> localPosition(const FlatVolume& volume, const Vec3<Real>& position) {
    return volume.localFromIndex * (position - 0.5f * volume.lastIndex);
}

}  // namespace pdr
