#pragma once
/// Upper bounds on the extinction of a cell, from the HU that interpolation can reach in it; exact for any curve. There
/// are stored bounds of grid cells, and bounds between eight voxels that are computed during traversal.

#include "render/base/cells.h"
#include "render/kernel/medium.h"

namespace pdr {

// Margins that bounds add for rounding. Stored and computed bounds add different amounts, none of them less than is
// derived here. The amounts must not change: bounds decide which random numbers a ray uses, so that any other amount
// changes the noise of every image.
//
// HU. trilinear() computes a + (b - a) s, 0 <= s <= 1, along x, then y, then z. Rounding is monotone: the product lies
// between 0 and the rounded b - a, and the sum between a and a plus that. So only the rounding of b - a leads beyond b.
// Along x there is none: voxels are whole numbers. Along y, and again along z, |b - a| < 2^16 is off by 2^-9 at most;
// the ends of int16 plus or minus that, or twice that, are rounded no farther out. Together this is 2^-8 HU, which
// extreme voxels do reach. Where all voxels agree there is none.

/// HU by which interpolation may exceed the range of its eight voxels. For bounds that are computed during traversal,
/// whose positions are clamped to their cell.
inline constexpr float kInterpolationRounding = 0x1p-8f;
/// HU margin of stored bounds: four times as much; the rest is for positions that single precision puts just beside
/// their cell.
inline constexpr float kHuSlack = 1.0f / 64;

// Opacity. opacityIn() is monotone, so that its values at the ends of an interval bound those between to the last bit.
// The margin is for the unrounded curve: the slope, hu - start, the product and the sum are rounded, each by 2^-24 of
// the curve's highest opacity at most: 2^-22 together.

/// Opacity margins of stored bounds: relative to the extinction, and relative to the curve's highest opacity where a
/// piece falls to nearly nothing.
inline constexpr float kRoundingRoom = 1 + 1e-5f, kRoundingRoomOfHighest = 0x1p-22f;
/// Opacity margin of bounds that are computed during traversal, relative to the highest opacity that any curve can
/// have: 1.
inline constexpr float kOpacityRoom = 0x1p-20f;

/// Returns the piece's opacity at `hu`. Inside a piece that is not 0 throughout it is never 0, however close `hu` is to
/// the end.
PDR_HD inline float opacityOrTrace(const OpacityPiece& piece, float hu) {
    const float value = opacityIn(piece, hu);
    if (value > 0 || !(hu > piece.start))
        return value;
    const float rise = piece.slope != 0 ? glm::abs(piece.slope) * (piece.end - piece.start) : 0.0f;
    return glm::max(piece.opacity, rise) * 0x1p-23f;
}

/// Returns the highest opacity of one piece over its part of [low, high]; 0 if it has none.
PDR_HD inline float highestOpacity(const OpacityPiece& piece, float low, float high) {
    const float from = glm::max(low, piece.start), to = glm::min(high, piece.end);
    if (!(from <= to))
        return 0;
    return glm::max(opacityOrTrace(piece, from), opacityOrTrace(piece, to));
}

/// Returns the highest opacity that a value in `range` can have. The range is widened by kHuSlack at each end unless it
/// is a single value (interpolation rounds). Returns 0 for an empty range and where the curve is 0, but not where it is
/// only rounded to 0.
PDR_HD inline float highestOpacity(const FlatTransferFunction& function, HuRange range) {
    if (range.empty())
        return 0;
    if (range.lowest == range.highest)
        return opacityOrTrace(function.pieces[pieceOf(function, range.lowest)], range.lowest);
    const float low = float(range.lowest) - kHuSlack, high = float(range.highest) + kHuSlack;
    float most = 0;
    for (int i = pieceOf(function, low); i < function.pieceCount && function.pieces[i].start <= high; ++i)
        most = glm::max(most, highestOpacity(function.pieces[i], low, high));
    return most;
}

/// Returns a bound on the extinction [1/mm] from the highest opacity of a cell and that of the whole curve.
PDR_HD inline float extinctionBound(float extinctionPerMm, float opacity, float highestOfCurve) {
    if (!(opacity > 0))
        return 0;
    return extinctionPerMm * glm::max(opacity * kRoundingRoom, opacity + kRoundingRoomOfHighest * highestOfCurve);
}

/// Returns a bound on the extinction between eight voxels [1/mm]; 0 where the curve is 0 for all HU that interpolation
/// can reach there.
template <class Real>
PDR_HD_INLINE Real extinctionBound(const FlatTransferFunction& function, const VoxelCell<Real>& cell) {
    Real low = cell.hu[0], high = cell.hu[0];
    for (int n = 1; n < 8; ++n) {
        low = min(low, cell.hu[n]);
        high = max(high, cell.hu[n]);
    }
    const auto varies = low < high;
    low = varies ? low - kInterpolationRounding : low;
    high = varies ? high + kInterpolationRounding : high;
    Real most{};
    for (int i = 0; i < function.pieceCount; ++i) {
        const OpacityPiece& piece = function.pieces[i];
        const Real from = max(low, Real{} + piece.start), to = min(high, Real{} + piece.end);
        const Real here = max(opacityIn(piece, from), opacityIn(piece, to));
        most = from <= to ? max(most, here) : most;
    }
    return most > 0.0f ? function.extinctionPerMm * (most + kOpacityRoom) : Real{};
}

/// Returns the same for the curves of the cell, in the lanes of `mask`.
template <class Real>
PDR_HD_INLINE Real extinctionBound(const FlatScene& scene, const VoxelCell<Real>& cell,
                                   typename SimdTraits<Real>::Mask mask) {
    if (!hasParts(scene))
        return extinctionBound(scene.transferFunction, cell);
    Real most{};
    forCurvesOfCell(scene, {toInt(cell.lowest.x), toInt(cell.lowest.y), toInt(cell.lowest.z)}, mask,
                    [&](int curve, auto here) {
                        const Real bound = extinctionBound(scene.parts.curves[curve], cell);
                        most = here ? max(most, bound) : most;
                    });
    return most;
}

/// Returns the lowest corner of a fine cell in index space; highCorner() returns the highest.
PDR_HD inline vec3 lowCorner(ivec3 cell) {
    return vec3((cell - 1) * kFineCell);
}
PDR_HD inline vec3 highCorner(ivec3 cell) {
    return vec3(cell * kFineCell);
}

}  // namespace pdr
