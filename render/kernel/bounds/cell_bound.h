#pragma once
/// Bounds on the extinction of a cell, from the HU that interpolation can meet in it: exact for any curve.
/// Within a piece the curve is evaluated by one formula whose rounding is monotone, so that its values at the ends of
/// an interval bound those between, to the last bit.

#include "render/base/cells.h"
#include "render/kernel/medium.h"

namespace pdr {

/// HU; interpolation rounds by at most 0.015 between the ends of int16.
inline constexpr float kHuSlack = 1.0f / 64;
/// Of the extinction: relative to it, and relative to the curve's highest opacity where a piece falls to nearly
/// nothing.
inline constexpr float kRoundingRoom = 1 + 1e-5f, kRoundingRoomOfHighest = 0x1p-22f;

/// The piece's opacity at `hu`; inside a piece that is not 0 throughout, never 0, however close to its end.
PDR_HD inline float opacityOrTrace(const OpacityPiece& piece, float hu) {
    const float value = piece.opacity + piece.slope * (hu - piece.start);
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

/// The index-space box of fine cells [low, high].
PDR_HD inline vec3 lowCorner(ivec3 cell) {
    return vec3((cell - 1) * kFineCell);
}
PDR_HD inline vec3 highCorner(ivec3 cell) {
    return vec3(cell * kFineCell);
}

}  // namespace pdr
