#pragma once
/// Bounds on the extinction of a cell, from the HU that interpolation can meet in it: exact for any curve. Stored ones
/// of grid cells, and those of eight voxels on the spot.

#include "render/base/cells.h"
#include "render/kernel/medium.h"

namespace pdr {

// What a bound adds for rounding. Stored bounds and those made on the spot add different amounts, none of them less
// than is derived here, and keep them: bounds decide which random numbers a ray takes, so that any other amount is
// other noise in every picture.
//
// HU. trilinear() takes a + (b - a) s, 0 <= s <= 1, along x, then y, then z. Rounding is monotone: the product lies
// between 0 and the rounded b - a, and the sum between a and a plus that. So only the rounding of b - a leads beyond b.
// Along x there is none: voxels are whole numbers. Along y, and again along z, |b - a| < 2^16 is off by 2^-9 at most;
// the ends of int16 plus or minus that, or twice that, are rounded no farther out. Together 2^-8 HU, which extreme
// voxels do reach. Where all voxels agree there is none.

/// HU by which interpolation may leave its eight voxels. For bounds made on the spot, whose places are kept inside.
inline constexpr float kInterpolationRounding = 0x1p-8f;
/// HU, for stored bounds: four times as much; the rest is for places that single precision puts just beside their cell.
inline constexpr float kHuSlack = 1.0f / 64;

// Opacity. opacityIn() is monotone, so that its values at the ends of an interval bound those between to the last bit.
// The room is for the curve as it was meant: the slope, hu - start, the product and the sum are rounded, each by 2^-24
// of the curve's highest opacity at most: 2^-22 together.

/// For stored bounds: relative to the extinction, and relative to the curve's highest opacity where a piece falls to
/// nearly nothing.
inline constexpr float kRoundingRoom = 1 + 1e-5f, kRoundingRoomOfHighest = 0x1p-22f;
/// For bounds made on the spot, of the highest opacity that any curve can have: 1.
inline constexpr float kOpacityRoom = 0x1p-20f;

/// The piece's opacity at `hu`; inside a piece that is not 0 throughout, never 0, however close to its end.
PDR_HD inline float opacityOrTrace(const OpacityPiece& piece, float hu) {
    const float value = opacityIn(piece, hu);
    if (value > 0 || !(hu > piece.start))
        return value;
    const float rise = piece.slope != 0 ? glm::abs(piece.slope) * (piece.end - piece.start) : 0.0f;
    return glm::max(piece.opacity, rise) * 0x1p-23f;
}

/// The highest opacity of one piece over its part of [low, high]; 0 where it has none.
PDR_HD inline float highestOpacity(const OpacityPiece& piece, float low, float high) {
    const float from = glm::max(low, piece.start), to = glm::min(high, piece.end);
    if (!(from <= to))
        return 0;
    return glm::max(opacityOrTrace(piece, from), opacityOrTrace(piece, to));
}

/// The highest opacity that a value in `range` can have, widened by kHuSlack at each end where the range is not a
/// single value (interpolation rounds). 0 for an empty range, and where the curve is 0, but not where it is only
/// rounded to 0.
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

/// A bound on the extinction [1/mm] from the highest opacity of a cell and that of the whole curve.
PDR_HD inline float extinctionBound(float extinctionPerMm, float opacity, float highestOfCurve) {
    if (!(opacity > 0))
        return 0;
    return extinctionPerMm * glm::max(opacity * kRoundingRoom, opacity + kRoundingRoomOfHighest * highestOfCurve);
}

/// A bound on the extinction between eight voxels [1/mm]; 0 where the curve is 0 over all that interpolation can meet
/// there.
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

/// The index-space box of fine cells [low, high].
PDR_HD inline vec3 lowCorner(ivec3 cell) {
    return vec3((cell - 1) * kFineCell);
}
PDR_HD inline vec3 highCorner(ivec3 cell) {
    return vec3(cell * kFineCell);
}

}  // namespace pdr
