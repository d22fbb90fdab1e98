#pragma once
/// The medium: opacity, extinction and material as functions of the HU.

#include "render/kernel/mask.h"

namespace pdr {

/// Returns the index of the piece of the curve that holds `hu`. Pieces include their start, not their end.
PDR_HD inline int pieceOf(const FlatTransferFunction& function, float hu) {
    int piece = function.pieceAt[(int(hu) + 32768) >> 4];
    while (hu >= function.pieces[piece].end)
        ++piece;
    return piece;
}

/// Returns the piece of the curve that holds `hu`.
PDR_HD inline const OpacityPiece& pieceHolding(const FlatTransferFunction& function, float hu) {
    return function.pieces[pieceOf(function, hu)];
}

#if !defined(__CUDACC__)

/// One piece for each lane.
struct OpacityPieceLanes {
    FloatLanes start{}, opacity{}, slope{};
};

/// Returns the piece that holds `hu` in each lane. It tries every piece, since curves have few and a look-up would
/// gather five numbers for each lane.
PDR_HD_INLINE OpacityPieceLanes pieceHolding(const FlatTransferFunction& function, FloatLanes hu) {
    OpacityPieceLanes found;
    for (int i = 0; i < function.pieceCount; ++i) {
        const OpacityPiece& piece = function.pieces[i];
        const IntLanes reached = hu >= piece.start;
        found.start = reached ? FloatLanes{} + piece.start : found.start;
        found.opacity = reached ? FloatLanes{} + piece.opacity : found.opacity;
        found.slope = reached ? FloatLanes{} + piece.slope : found.slope;
    }
    return found;
}

#endif

/// Returns the opacity at `hu` on the line of one piece; with rounding, it stays monotone in `hu`.
template <class Piece, class Real>
PDR_HD_INLINE Real opacityIn(const Piece& piece, Real hu) {
    return piece.opacity + piece.slope * (hu - piece.start);
}

/// Returns the opacity at `hu`, in [0, 1].
PDR_HD inline float opacity(const FlatTransferFunction& function, float hu) {
    return opacityIn(pieceHolding(function, hu), hu);
}

/// Returns the extinction at `hu` [1/mm].
template <class Real>
PDR_HD_INLINE Real extinctionOf(const FlatTransferFunction& function, Real hu) {
    return function.extinctionPerMm * opacityIn(pieceHolding(function, hu), hu);
}

/// Returns the extinction at `position` (index space) [1/mm]: that of the tissue times its visibility weight.
template <class Real>
PDR_HD_INLINE Real extinction(const FlatScene& scene, const Vec3<Real>& position) {
    const Real whole = extinctionOf(scene.transferFunction, hounsfield(scene.volume, position));
    return isMasked(scene) ? whole * weightAt(scene, position) : whole;
}

PDR_HD inline float extinction(const FlatScene& scene, vec3 position) {
    return extinction(scene, Vec3<float>{position.x, position.y, position.z});
}

PDR_HD_INLINE Material materialAt(const FlatTransferFunction& function, float hu) {
    const int index = pieceOf(function, hu);
    const OpacityPiece& piece = function.pieces[index];
    const Material& a = function.materials[2 * index];
    const Material& b = function.materials[2 * index + 1];
    const float width = piece.end - piece.start;
    const float fraction = width < 1e6f ? (hu - piece.start) / width : 0.0f;  // the outermost pieces are constant
    return {glm::mix(a.albedo, b.albedo, fraction), glm::mix(a.emission, b.emission, fraction),
            glm::mix(a.specular, b.specular, fraction), glm::mix(a.roughness, b.roughness, fraction)};
}

}  // namespace pdr
