#pragma once
/// From Hounsfield units to optics.

#include "render/kernel/density.h"

namespace pdr {

/// The piece of the curve that holds `hu`; right-continuous.
PDR_HD inline int pieceOf(const FlatTransferFunction& function, float hu) {
    int piece = function.pieceAt[(int(hu) + 32768) >> 4];
    while (hu >= function.pieces[piece].end)
        ++piece;
    return piece;
}

/// [0, 1]
PDR_HD inline float opacity(const FlatTransferFunction& function, float hu) {
    const OpacityPiece& piece = function.pieces[pieceOf(function, hu)];
    return piece.opacity + piece.slope * (hu - piece.start);
}

/// Extinction at `position` (index space) [1/mm].
PDR_HD inline float extinction(const FlatScene& scene, vec3 position) {
    return scene.transferFunction.extinctionPerMm * opacity(scene.transferFunction, hounsfield(scene.volume, position));
}

PDR_HD inline float extinction(const FlatScene& scene, const Vec3<float>& position) {
    return extinction(scene, vec3(position.x, position.y, position.z));
}

#if !defined(__CUDACC__)

/// The same in step, bit by bit: curves have few pieces, so every piece is tried.
PDR_HD_INLINE FloatLanes extinction(const FlatScene& scene, const Vec3<FloatLanes>& position) {
    const FlatTransferFunction& function = scene.transferFunction;
    const FloatLanes hu = hounsfield(scene.volume, position);
    FloatLanes start{}, value{}, slope{};
    for (int i = 0; i < function.pieceCount; ++i) {
        const OpacityPiece& piece = function.pieces[i];
        const IntLanes inside = i == 0 ? hu < piece.end : hu >= piece.start;
        start = inside ? FloatLanes{} + piece.start : start;
        value = inside ? FloatLanes{} + piece.opacity : value;
        slope = inside ? FloatLanes{} + piece.slope : slope;
    }
    return function.extinctionPerMm * (value + slope * (hu - start));
}

#endif

PDR_HD_INLINE Material materialAt(const FlatTransferFunction& function, float hu) {
    const int index = pieceOf(function, hu);
    const OpacityPiece& piece = function.pieces[index];
    const Material& a = function.materials[2 * index];
    const Material& b = function.materials[2 * index + 1];
    const float width = piece.end - piece.start;
    const float share = width < 1e6f ? (hu - piece.start) / width : 0.0f;  // the outermost pieces are constant
    return {glm::mix(a.albedo, b.albedo, share), glm::mix(a.emission, b.emission, share),
            glm::mix(a.specular, b.specular, share), glm::mix(a.roughness, b.roughness, share)};
}

}  // namespace pdr
