#include "render/prepare/thin_curve.h"

#include <algorithm>

#include "render/kernel/walk/thin_walk.h"

namespace pdr {

namespace {

/// Returns the HU over which a piece of the curve has an opacity of at most `thin`; 0 where it is clear.
float thinHu(const OpacityPiece& piece, float thin) {
    const float width = piece.end - piece.start, last = piece.opacity + piece.slope * width;
    const float least = std::min(piece.opacity, last), most = std::max(piece.opacity, last);
    if (!(most > 0) || least >= thin)
        return 0;
    return most <= thin ? width : width * (thin - least) / (most - least);
}

}  // namespace

bool showsThinTissue(const FlatTransferFunction& function, const FlatVolume& volume) {
    constexpr float kEnough = 64;
    const float thin = thinBound(volume) / function.extinctionPerMm;
    float hu = 0;
    for (int i = 1; i + 1 < function.pieceCount; ++i)
        hu += thinHu(function.pieces[i], thin);
    return hu >= kEnough;
}

}  // namespace pdr
