#pragma once
/// Which curve each voxel has where parts of the patient have curves of their own. Kernels that may have parts call
/// hasParts() first.

#include <bit>
#include <cstdint>
#include <cstring>

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

/// Returns the labels of two voxels that are neighbours along x, the first one in the low byte.
PDR_HD inline std::uint32_t labelPair(const std::uint8_t* first, int step) {
#if !defined(__CUDACC__)
    if (step == 1) {
        std::uint16_t both;
        std::memcpy(&both, first, sizeof both);
        return both;
    }
#endif
    return first[0] | std::uint32_t(first[step]) << 8;
}

/// Returns the labels at the corners of the cell between voxels whose lowest corner is voxel `corner`, in
/// [0, lastCorner]: byte x + 2 y + 4 z from the lowest.
PDR_HD inline std::uint64_t cornerLabels(const FlatScene& scene, ivec3 corner) {
    const FlatVolume& volume = scene.volume;
    const std::uint8_t* lowest = scene.parts.labels + corner.z * volume.stepZ + corner.y * volume.stepY + corner.x;
    const auto pair = [&](std::int64_t step) { return labelPair(lowest + step, volume.stepX); };
    const std::uint32_t low = pair(0) | pair(volume.stepY) << 16;
    const std::uint32_t high = pair(volume.stepZ) | pair(volume.stepY + volume.stepZ) << 16;
    return low | std::uint64_t(high) << 32;
}

PDR_HD inline int labelAt(std::uint64_t labels, int n) {
    return int(labels >> (8 * n) & 0xFF);
}

PDR_HD inline bool isOneLabel(std::uint64_t labels) {
    return labels == (labels & 0xFF) * 0x0101010101010101u;
}

/// Returns the curve at corner `n` of a cell with these labels, for its opacity alone.
PDR_HD inline std::uint8_t curveAt(const FlatScene& scene, std::uint64_t labels, int n) {
    return scene.parts.curveOf[labelAt(labels, n)];
}

/// Returns the curves at the corners of a cell with these labels, for their opacity alone.
PDR_HD inline CornerCurves cornerCurves(const FlatScene& scene, std::uint64_t labels) {
    CornerCurves corners;
    for (int n = 0; n < 8; ++n)
        corners.curve[n] = curveAt(scene, labels, n);
    return corners;
}
PDR_HD inline CornerCurves cornerCurves(const FlatScene& scene, ivec3 corner) {
    return cornerCurves(scene, cornerLabels(scene, corner));
}

/// Returns the curve at corner `n` of a cell with these labels that has its colours and surfaces, too.
PDR_HD inline int materialAt(const FlatScene& scene, std::uint64_t labels, int n) {
    return scene.parts.materialOf[labelAt(labels, n)];
}

/// Returns whether all corners of a cell with these labels are of one material.
PDR_HD inline bool isOneMaterial(const FlatScene& scene, std::uint64_t labels) {
    if (isOneLabel(labels))
        return true;
    for (int n = 1; n < 8; ++n)
        if (materialAt(scene, labels, n) != materialAt(scene, labels, 0))
            return false;
    return true;
}

/// Value of onlyCurve() where there are several.
inline constexpr int kSeveralCurves = -1;

/// Returns the curve that all corners of a cell with these labels have, or kSeveralCurves.
PDR_HD inline int onlyCurve(const FlatScene& scene, std::uint64_t labels) {
    const int first = curveAt(scene, labels, 0);
    if (isOneLabel(labels))
        return first;
    for (int n = 1; n < 8; ++n)
        if (curveAt(scene, labels, n) != first)
            return kSeveralCurves;
    return first;
}

/// Returns the curve that all corners of the cell between voxels have, or kSeveralCurves and their `labels`.
PDR_HD inline int onlyCurve(const FlatScene& scene, ivec3 corner, std::uint64_t& labels) {
    const int only = scene.parts.onlyCurve[cellIndex(corner / kFineCell + 1, scene.majorants.fineSize)];
    if (only != kMixedCell)
        return only;
    labels = cornerLabels(scene, corner);
    return onlyCurve(scene, labels);
}

PDR_HD inline int onlyCurve(const FlatScene& scene, ivec3 corner, bool mask, std::uint64_t& labels) {
    return mask ? onlyCurve(scene, corner, labels) : 0;
}

#if !defined(__CUDACC__)

/// Returns the curve of each lane in which `mask` holds; 0 in the others.
inline IntLanes onlyCurve(const FlatScene& scene, const Vec3<IntLanes>& corner, IntLanes mask, BitsLanes& labels) {
    const ivec3 fine = scene.majorants.fineSize;
    const auto cell = [](IntLanes voxel) { return (voxel >> 2) + 1; };  // kFineCell is 4
    const IntLanes index = (cell(corner.z) * fine.y + cell(corner.y)) * fine.x + cell(corner.x);
    IntLanes only{};
    for (int lane = 0; lane < kLanes; ++lane)
        only[lane] = scene.parts.onlyCurve[index[lane]];
    for (std::uint32_t mixed = laneBits(mask & (only == kMixedCell)); mixed != 0; mixed &= mixed - 1) {
        const int lane = std::countr_zero(mixed);
        labels[lane] = cornerLabels(scene, ivec3(corner.x[lane], corner.y[lane], corner.z[lane]));
        only[lane] = onlyCurve(scene, labels[lane]);
    }
    return mask ? only : IntLanes{};
}

/// Calls together(curve, lanes) for the curve of the first lane in `mask` and all lanes that have it, then alone(lane)
/// for each other one: few are.
template <class Together, class Alone>
PDR_HD_INLINE void forCurvesOfLanes(IntLanes curve, IntLanes mask, Together&& together, Alone&& alone) {
    const std::uint32_t known = laneBits(mask & (curve != kSeveralCurves));
    IntLanes same{};
    if (known != 0) {
        const int first = curve[std::countr_zero(known)];
        same = mask & (curve == first);
        together(first, same);
    }
    for (std::uint32_t left = laneBits(mask & !same); left != 0; left &= left - 1)
        alone(std::countr_zero(left));
}

#endif

/// Calls visit(curve, mask) for the curves at the corners of each lane's cell, where `mask` holds; for some several
/// times. The visit's own mask: the lanes whose cell has that curve there.
template <class Visit>
PDR_HD_INLINE void forCurvesOfCell(const FlatScene& scene, const Vec3<int>& corner, bool mask, Visit&& visit) {
    if (!mask)
        return;
    const CornerCurves corners = cornerCurves(scene, ivec3(corner.x, corner.y, corner.z));
    for (int n = 0; n < 8; ++n)
        if (n == 0 || corners.curve[n] != corners.curve[n - 1])
            visit(corners.curve[n], true);
}

#if !defined(__CUDACC__)

/// Calls visit(curve, mask) for each curve in the lanes of `mask`, with those that have it.
template <class Visit>
PDR_HD_INLINE void forEachCurve(IntLanes curve, IntLanes mask, Visit&& visit) {
    for (IntLanes left = mask; any(left);) {
        const int first = curve[std::countr_zero(laneBits(left))];
        const IntLanes here = left & (curve == first);
        visit(first, here);
        left = left & ~here;
    }
}

template <class Visit>
PDR_HD_INLINE void forCurvesOfCell(const FlatScene& scene, const Vec3<IntLanes>& corner, IntLanes mask, Visit&& visit) {
    std::uint64_t labels[kLanes]{};
    for (int lane = 0; lane < kLanes; ++lane)
        if (mask[lane])
            labels[lane] = cornerLabels(scene, ivec3(corner.x[lane], corner.y[lane], corner.z[lane]));
    for (int n = 0; n < 8; ++n) {
        IntLanes curve;
        for (int lane = 0; lane < kLanes; ++lane)
            curve[lane] = curveAt(scene, labels[lane], n);
        forEachCurve(curve, mask, visit);
    }
}

#endif

}  // namespace pdr
