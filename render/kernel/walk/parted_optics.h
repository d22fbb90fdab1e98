#pragma once
/// A ray segment through parts with curves of their own. In a cell whose eight voxels have one curve, it is as if that
/// were the scene's. Elsewhere the extinction is trilinear between those of the corners' curves. On a segment that
/// crosses no border of a piece of any of these curves, each corner's extinction is linear in the HU; so, with base and
/// slope trilinear between the corners,
///   extinction(s) = base(s) + slope(s) (hu(s) - hu(0)),
/// cubic polynomials all three, whose mean is known in closed form. With the visibility weight the degree is nine,
/// which Gauss's rule of five points integrates exactly.

#include "render/kernel/medium.h"
#include "render/kernel/walk/cell_walk.h"
#include "render/kernel/walk/masked_optics.h"

namespace pdr {

/// What the curves at the corners of a cell have in common: for cells with several.
template <class Real>
struct CornerPieces {
    VoxelCell<Real> base;     ///< extinction at the HU where a segment begins [1/mm]
    VoxelCell<Real> slope;    ///< change of the extinction [1/mm per HU]
    OpticsPiece<Real> piece;  ///< HU on which all corners' pieces hold; index: of the first corner's
};

/// Finds the pieces of the corners' curves in which a segment begins.
PDR_HD inline CornerPieces<float> cornerPieces(const FlatScene& scene, std::uint64_t labels, const Cubic<float>& hu) {
    const CornerCurves corners = cornerCurves(scene, labels);
    CornerPieces<float> found{};
    for (int n = 0; n < 8; ++n) {
        int same = 0;
        while (corners.curve[same] != corners.curve[n])
            ++same;
        if (same < n) {
            found.base.hu[n] = found.base.hu[same];
            found.slope.hu[n] = found.slope.hu[same];
            continue;
        }
        const FlatTransferFunction& curve = scene.parts.curves[corners.curve[n]];
        const OpticsPiece<float> piece = pieceAtBegin(scene.optics, curve, hu);
        const OpacityPiece& line = curve.pieces[piece.index - curve.firstPiece];
        found.base.hu[n] = max(curve.extinctionPerMm * opacityIn(line, hu.b0), 0.0f);
        found.slope.hu[n] = curve.extinctionPerMm * line.slope;
        if (n == 0)
            found.piece = piece;
        found.piece.start = max(found.piece.start, piece.start);
        found.piece.end = min(found.piece.end, piece.end);
    }
    return found;
}

PDR_HD_INLINE void findCornerPieces(const FlatScene& scene, const PartedHuAlong<float>& cell, bool mask,
                                    const Cubic<float>& hu, CornerPieces<float>& found) {
    if (mask)
        found = cornerPieces(scene, cell.labels, hu);
}

#if !defined(__CUDACC__)

/// Finds the same in the lanes of `mask`, one after the other: few lanes are in such a cell.
inline void findCornerPieces(const FlatScene& scene, const PartedHuAlong<FloatLanes>& cell, IntLanes mask,
                             const Cubic<FloatLanes>& hu, CornerPieces<FloatLanes>& found) {
    for (int lane = 0; lane < kLanes; ++lane) {
        if (!mask[lane])
            continue;
        const CornerPieces<float> one =
            cornerPieces(scene, cell.labels[lane], {hu.b0[lane], hu.b1[lane], hu.b2[lane], hu.b3[lane]});
        for (int n = 0; n < 8; ++n) {
            found.base.hu[n][lane] = one.base.hu[n];
            found.slope.hu[n][lane] = one.slope.hu[n];
        }
        found.piece.index[lane] = one.piece.index;
        found.piece.start[lane] = one.piece.start;
        found.piece.end[lane] = one.piece.end;
    }
}

#endif

/// Finds the piece of the number-`curve` curve that the segment `hu` begins in, where `mask` holds.
PDR_HD_INLINE void findPieces(const FlatScene& scene, int curve, bool mask, const Cubic<float>& hu,
                              OpticsPiece<float>& piece) {
    if (mask)
        piece = pieceAtBegin(scene.optics, scene.parts.curves[curve], hu);
}

#if !defined(__CUDACC__)

/// Finds the piece of each lane's curve: those of the first lane's together, others one after the other.
inline void findPieces(const FlatScene& scene, IntLanes curve, IntLanes mask, const Cubic<FloatLanes>& hu,
                       OpticsPiece<FloatLanes>& piece) {
    forCurvesOfLanes(
        curve, mask,
        [&](int first, IntLanes same) {
            const OpticsPiece<FloatLanes> found = pieceAtBegin(scene.optics, scene.parts.curves[first], hu);
            piece = {same ? found.index : piece.index, same ? found.start : piece.start, same ? found.end : piece.end};
        },
        [&](int lane) {
            const Cubic<float> alone{hu.b0[lane], hu.b1[lane], hu.b2[lane], hu.b3[lane]};
            const OpticsPiece<float> one = pieceAtBegin(scene.optics, scene.parts.curves[curve[lane]], alone);
            piece.index[lane] = one.index;
            piece.start[lane] = one.start;
            piece.end[lane] = one.end;
        });
}

#endif

/// Returns the piece that the segment `hu` through `cell` begins in, and what its corners have there in `corners`,
/// where there are several curves.
template <class Real>
PDR_HD_INLINE OpticsPiece<Real> pieceAtBegin(const FlatScene& scene, const PartedHuAlong<Real>& cell,
                                             typename SimdTraits<Real>::Mask mask, const Cubic<Real>& hu,
                                             CornerPieces<Real>& corners) {
    using Mask = typename SimdTraits<Real>::Mask;
    const Mask several = mask & (cell.curve == kSeveralCurves);
    OpticsPiece<Real> piece{};
    if (any(several)) {
        findCornerPieces(scene, cell, several, hu, corners);
        piece = {several ? corners.piece.index : piece.index, several ? corners.piece.start : piece.start,
                 several ? corners.piece.end : piece.end};
    }
    findPieces(scene, cell.curve, mask & !several, hu, piece);
    return piece;
}

/// The extinction along a segment of several curves: the formula at the top of this file.
template <class Real>
struct MixedAlong {
    typename SimdTraits<Real>::Mask several;  ///< there are several curves
    Cubic<Real> base, slope;
};

/// Sets `mixed` for the segment from one position in a cell to another, both as its fractions.
template <class Real>
PDR_HD_INLINE void mix(const CornerPieces<Real>& corners, typename SimdTraits<Real>::Mask several,
                       const Vec3<Real>& from, const Vec3<Real>& to, MixedAlong<Real>& mixed) {
    mixed.several = several;
    mixed.base = hounsfieldAlong(corners.base, from, to);
    mixed.slope = hounsfieldAlong(corners.slope, from, to);
}

/// The visible extinction along a segment through parts.
template <class Real>
struct PartedExtinction {
    using Mask = typename SimdTraits<Real>::Mask;

    const OpticsAlong<Real>& along;
    const Cubic<Real>& hu;
    const Cubic<Real>& weight;  ///< only with a mask
    bool masked;
    const MixedAlong<Real>& mixed;

    PDR_HD_INLINE Real at(Real s) const {
        const Real mix = max(mixed.base.at(s) + mixed.slope.at(s) * (hu.at(s) - hu.b0), Real{});
        const Real whole = mixed.several ? mix : extinctionAt(along, s);
        return masked ? whole * max(weight.at(s), Real{}) : whole;
    }
    /// Returns where the extinction is not that of the piece.
    PDR_HD_INLINE Mask differs() const { return masked ? mixed.several | hidden() : mixed.several; }
    /// Returns its mean along the segment.
    PDR_HD_INLINE Real mean() const {
        const Real whole = any(mixed.several) ? wholeMean() : along.meanExtinction;
        if (!masked || !any(hidden()))
            return whole;
        Real mean{};
        for (int i = 0; i < kGaussPlaces; ++i)
            mean = mean + gaussPlace(i).share * at(Real{} + gaussPlace(i).place);
        return hidden() ? mean : whole;
    }

  private:
    PDR_HD_INLINE Mask hidden() const { return weight.lowest() < 1.0f; }
    /// Returns the mean where nothing is hidden.
    PDR_HD_INLINE Real wholeMean() const {
        const Cubic<Real> rise{Real{}, hu.b1 - hu.b0, hu.b2 - hu.b0, hu.b3 - hu.b0};
        const Real mean = max(mixed.base.mean() + meanOfProduct(mixed.slope, rise), Real{});
        return mixed.several ? mean : along.meanExtinction;
    }
};

}  // namespace pdr
