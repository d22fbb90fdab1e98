#pragma once
/// Which curve each voxel has where parts of the patient have curves of their own. Kernels that may have parts call
/// hasParts() first.

#include <bit>
#include <cstdint>

#include "render/base/cells.h"
#include "render/base/lanes.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

static_assert(kFineCell == 4);

PDR_HD inline bool hasParts(const FlatScene& scene) {
    return scene.parts.labels != nullptr;
}

/// What a walk must know of the tissue, besides its HU. It is a template parameter, so that scenes without masks and
/// parts run code without them.
enum class Tissue {
    whole,   ///< all of it is visible
    masked,  ///< a mask hides some of it
    parted,  ///< its parts have curves of their own, and a mask may hide some
};

/// Returns call.operator()<Kind>() for the kind of the scene's tissue.
template <class Call>
PDR_HD_INLINE auto forTissue(const FlatScene& scene, Call&& call) {
    if (hasParts(scene))
        return call.template operator()<Tissue::parted>();
    return scene.mask.voxels != nullptr ? call.template operator()<Tissue::masked>()
                                        : call.template operator()<Tissue::whole>();
}

/// The curves of the eight voxels around a position: [x + 2 y + 4 z] from the lowest.
struct CornerCurves {
    std::uint8_t curve[8];
};

/// Returns the curves at the corners of the cell between voxels whose lowest corner is voxel `corner`, in
/// [0, lastCorner].
PDR_HD inline CornerCurves cornerCurves(const FlatScene& scene, ivec3 corner) {
    const FlatVolume& volume = scene.volume;
    const std::uint8_t* lowest = scene.parts.labels + corner.z * volume.stepZ + corner.y * volume.stepY + corner.x;
    CornerCurves corners;
    for (int n = 0; n < 8; ++n)
        corners.curve[n] =
            scene.parts
                .curveOf[lowest[(n & 1) * volume.stepX + ((n >> 1) & 1) * volume.stepY + (n >> 2) * volume.stepZ]];
    return corners;
}

/// Value of onlyCurve() where there are several.
inline constexpr int kSeveralCurves = -1;

/// Returns the curve that all corners of the cell between voxels have, or kSeveralCurves.
PDR_HD inline int onlyCurve(const FlatScene& scene, ivec3 corner) {
    const ivec3 fine = scene.majorants.fineSize, cell = corner / kFineCell + 1;
    const int only = scene.parts.onlyCurve[(std::int64_t(cell.z) * fine.y + cell.y) * fine.x + cell.x];
    if (only != kMixedCell)
        return only;
    const CornerCurves corners = cornerCurves(scene, corner);
    for (int n = 1; n < 8; ++n)
        if (corners.curve[n] != corners.curve[0])
            return kSeveralCurves;
    return corners.curve[0];
}

#if !defined(__CUDACC__)

/// Returns the curve of each lane in which `mask` holds; 0 in the others.
inline IntLanes onlyCurve(const FlatScene& scene, const Vec3<IntLanes>& corner, IntLanes mask) {
    const ivec3 fine = scene.majorants.fineSize;
    const auto cell = [](IntLanes voxel) { return (voxel >> 2) + 1; };  // kFineCell is 4
    const IntLanes index = (cell(corner.z) * fine.y + cell(corner.y)) * fine.x + cell(corner.x);
    IntLanes only{};
    for (int lane = 0; lane < kLanes; ++lane)
        only[lane] = scene.parts.onlyCurve[index[lane]];
    const IntLanes mixed = mask & (only == kMixedCell);
    if (any(mixed))
        for (int lane = 0; lane < kLanes; ++lane)
            if (mixed[lane])
                only[lane] = onlyCurve(scene, ivec3(corner.x[lane], corner.y[lane], corner.z[lane]));
    return mask ? only : IntLanes{};
}

#endif

PDR_HD inline int onlyCurve(const FlatScene& scene, const Vec3<int>& corner, bool mask) {
    return mask ? onlyCurve(scene, ivec3(corner.x, corner.y, corner.z)) : 0;
}

/// Returns the curve of the voxel at corner `n` of a cell, in the lanes of `mask`; 0 in the others.
PDR_HD inline int cornerCurve(const FlatScene& scene, const Vec3<int>& corner, int n, bool mask) {
    return mask ? cornerCurves(scene, ivec3(corner.x, corner.y, corner.z)).curve[n] : 0;
}

#if !defined(__CUDACC__)

inline IntLanes cornerCurve(const FlatScene& scene, const Vec3<IntLanes>& corner, int n, IntLanes mask) {
    IntLanes curve{};
    for (int lane = 0; lane < kLanes; ++lane)
        if (mask[lane])
            curve[lane] = cornerCurves(scene, ivec3(corner.x[lane], corner.y[lane], corner.z[lane])).curve[n];
    return curve;
}

#endif

/// Calls visit(curve, mask) for each curve in the lanes of `mask`, with those that have it.
template <class Visit>
PDR_HD_INLINE void forEachCurve(int curve, bool mask, Visit&& visit) {
    if (mask)
        visit(curve, true);
}

#if !defined(__CUDACC__)

template <class Visit>
PDR_HD_INLINE void forEachCurve(IntLanes curve, IntLanes mask, Visit&& visit) {
    for (IntLanes left = mask; any(left);) {
        const int first = curve[std::countr_zero(laneBits(left))];
        const IntLanes here = left & (curve == first);
        visit(first, here);
        left = left & ~here;
    }
}

#endif

}  // namespace pdr
