#include "render/prepare/thin_curve.h"

#include <algorithm>

#include "render/base/cells.h"
#include "render/kernel/bounds/cell_bound.h"
#include "render/kernel/walk/thin_walk.h"

namespace pdr {

namespace {

/// Returns the longest diagonal of a voxel [mm]; that of a sheared one need not be the one along (1, 1, 1).
float longestDiagonal(const mat3& localFromIndex) {
    float most = 0;
    for (int n = 0; n < 4; ++n)
        most = std::max(most, glm::length(localFromIndex * vec3(1, n & 1 ? -1 : 1, n & 2 ? -1 : 1)));
    return most;
}

/// Returns the HU over which a piece of the curve has an opacity of at most `thin`; 0 where it is clear.
float thinHu(const OpacityPiece& piece, float thin) {
    const float width = piece.end - piece.start, last = piece.opacity + piece.slope * width;
    const float least = std::min(piece.opacity, last), most = std::max(piece.opacity, last);
    if (!(most > 0) || least >= thin)
        return 0;
    return most <= thin ? width : width * (thin - least) / (most - least);
}

}  // namespace

float thinBound(const FlatVolume& volume) {
    return kThinDepth / (kFineCell * longestDiagonal(volume.localFromIndex));
}

bool showsThinTissue(const FlatTransferFunction& function, const FlatVolume& volume) {
    constexpr float kEnough = 96;
    const float thin = thinBound(volume) / function.extinctionPerMm;
    float hu = 0;
    for (int i = 1; i + 1 < function.pieceCount; ++i)
        hu += thinHu(function.pieces[i], thin);
    return hu >= kEnough;
}

bool showsSoftTissue(const FlatTransferFunction& function, const FlatVolume& volume) {
    constexpr HuRange kFatToMuscle{-150, 100};
    constexpr float kMost = 8;  // times thinBound(): of a voxel's diagonal, an optical depth of 1
    const float most = function.extinctionPerMm * highestOpacity(function, kFatToMuscle);
    return most > 0 && most <= kMost * thinBound(volume);
}

bool showsDenseTissue(const FlatTransferFunction& function, const FlatVolume& volume) {
    constexpr float kDense = 7.5f;  // optical depth of a voxel
    return function.extinctionPerMm * longestDiagonal(volume.localFromIndex) > kDense;
}

}  // namespace pdr
