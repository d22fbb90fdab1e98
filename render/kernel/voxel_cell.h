#pragma once
/// The cell between eight neighbouring voxel centres, in which trilinear interpolation is a single formula.

#include <initializer_list>

#include "render/base/extremes.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

template <class Real>
struct VoxelCell {
    Vec3<Real> lowest;  ///< lowest corner, index space
    Real hu[8];         ///< HU at the corners: [x + 2 y + 4 z] from the lowest
};

/// Returns the cell whose lowest corner is voxel `corner`, in [0, lastCorner].
PDR_HD_INLINE VoxelCell<float> cellAt(const FlatGrid& volume, const Vec3<int>& corner) {
    VoxelCell<float> cell;
    cell.lowest = {float(corner.x), float(corner.y), float(corner.z)};
    const std::int16_t* v = volume.voxels + corner.z * volume.stepZ + corner.y * volume.stepY + corner.x;
    for (int n = 0; n < 8; ++n)
        cell.hu[n] = v[(n & 1) * volume.stepX + ((n >> 1) & 1) * volume.stepY + (n >> 2) * volume.stepZ];
    return cell;
}

/// Does nothing: a single ray leaves prefetching to the processor.
PDR_HD_INLINE void prefetchCell(const FlatGrid&, const Vec3<int>&) {}

#if !defined(__CUDACC__)

/// Returns the offset of a voxel from the first voxel in each lane. The volume must have fewer than 2^31 voxels.
inline IntLanes voxelIndex(const FlatGrid& volume, const Vec3<IntLanes>& voxel) {
    return (voxel.z * volume.size.y + voxel.y) * volume.size.x + voxel.x;
}

/// Returns the cell of each lane. The volume must have at least two voxels along x: neighbours along x are read as one
/// word.
PDR_HD_INLINE VoxelCell<FloatLanes> cellAt(const FlatGrid& volume, const Vec3<IntLanes>& corner) {
    const IntLanes index = voxelIndex(volume, corner);
    VoxelCell<FloatLanes> cell;
    cell.lowest = {toFloat(corner.x), toFloat(corner.y), toFloat(corner.z)};
    const auto row = [&](int n, std::int64_t from) {
        gatherPair(volume.voxels + from, index, cell.hu[n], cell.hu[n + 1]);
    };
    row(0, 0);  // not in a loop: there GCC 12 reads lane by lane instead of by gather instructions
    row(2, volume.stepY);
    row(4, volume.stepZ);
    row(6, volume.stepZ + volume.stepY);
    return cell;
}

/// Prefetches the memory of a cell before it is read.
PDR_HD_INLINE void prefetchCell(const FlatGrid& volume, const Vec3<IntLanes>& corner) {
    const IntLanes index = voxelIndex(volume, corner);
    for (const std::int64_t from : {std::int64_t(0), volume.stepY, volume.stepZ, volume.stepZ + volume.stepY})
        prefetch(volume.voxels + from, index);
}

#endif

/// Returns the lowest corner of the cell at voxel `corner`, or of the outermost cell at the volume's borders. Where
/// `mask` does not hold, it returns voxel 0.
template <class Int, class Mask>
PDR_HD_INLINE Vec3<Int> nearestCorner(const FlatGrid& volume, const Vec3<Int>& corner, Mask mask) {
    const auto inside = [mask](Int value, float last) {
        const Int high = Int{} + int(last);
        value = value < 0 ? Int{} : value;
        value = value > high ? high : value;
        return mask ? value : Int{};
    };
    return {inside(corner.x, volume.lastCorner.x), inside(corner.y, volume.lastCorner.y),
            inside(corner.z, volume.lastCorner.z)};
}

template <class Int, class Mask>
PDR_HD_INLINE auto nearestCell(const FlatGrid& volume, const Vec3<Int>& corner, Mask mask) {
    return cellAt(volume, nearestCorner(volume, corner, mask));
}

/// Returns where `position` (index space) lies in the cell, in [0, 1] along each axis; positions outside are clamped to
/// the border.
template <class Real>
PDR_HD_INLINE Vec3<Real> fractionsIn(const VoxelCell<Real>& cell, const Vec3<Real>& position) {
    const auto fraction = [](Real place, Real lowest) {
        return lesser(greater(place - lowest, Real{}), Real{} + 1.0f);
    };
    return {fraction(position.x, cell.lowest.x), fraction(position.y, cell.lowest.y),
            fraction(position.z, cell.lowest.z)};
}

/// Returns the HU at fractions in [0, 1] of the cell. Where all eight voxels agree, the result is exactly their value.
template <class Real>
PDR_HD_INLINE Real trilinear(const VoxelCell<Real>& cell, const Vec3<Real>& fraction) {
    const auto mix = [](Real a, Real b, Real fraction) { return a + (b - a) * fraction; };
    const auto alongX = [&](int n) { return mix(cell.hu[n], cell.hu[n + 1], fraction.x); };
    const Real low = mix(alongX(0), alongX(2), fraction.y);
    const Real high = mix(alongX(4), alongX(6), fraction.y);
    return mix(low, high, fraction.z);
}

}  // namespace pdr
