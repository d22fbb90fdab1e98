#pragma once
/// From Hounsfield units to optics.

#include "render/kernel/volume_sampling.h"

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

/// [1/mm]
PDR_HD inline float extinctionOf(const FlatTransferFunction& function, float hu) {
    return function.extinctionPerMm * opacity(function, hu);
}

/// Extinction at `position` (index space) [1/mm].
PDR_HD inline float extinction(const FlatScene& scene, vec3 position) {
    return extinctionOf(scene.transferFunction, hounsfield(scene.volume, position));
}

PDR_HD inline float extinction(const FlatScene& scene, const Vec3<float>& position) {
    return extinction(scene, vec3(position.x, position.y, position.z));
}

#if !defined(__CUDACC__)

/// The same in step, bit by bit: curves have few pieces, so every piece is tried.
PDR_HD_INLINE FloatLanes extinctionOf(const FlatTransferFunction& function, FloatLanes hu) {
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

PDR_HD_INLINE FloatLanes extinction(const FlatScene& scene, const Vec3<FloatLanes>& position) {
    return extinctionOf(scene.transferFunction, hounsfield(scene.volume, position));
}

#endif

/// A bound on the extinction in a cube [1/mm]; 0 where the curve is 0 over all that interpolation can meet there.
template <class Real>
PDR_HD_INLINE Real extinctionBound(const FlatTransferFunction& function, const Cube<Real>& cube) {
    constexpr float kHuRoom = 1.0f / 256, kOpacityRoom = 0x1p-20f;  // interpolation and the curve round
    Real low = cube.hu[0], high = cube.hu[0];
    for (int n = 1; n < 8; ++n) {
        low = min(low, cube.hu[n]);
        high = max(high, cube.hu[n]);
    }
    const auto varies = low < high;
    low = varies ? low - kHuRoom : low;
    high = varies ? high + kHuRoom : high;
    Real most{};
    for (int i = 0; i < function.pieceCount; ++i) {
        const OpacityPiece& piece = function.pieces[i];
        const Real from = i == 0 ? low : max(low, Real{} + piece.start);
        const Real to = min(high, Real{} + piece.end);
        const auto value = [&](Real hu) { return piece.opacity + piece.slope * (hu - piece.start); };
        const Real here = max(value(from), value(to));
        most = from <= to ? max(most, here) : most;
    }
    return most > 0.0f ? function.extinctionPerMm * (most + kOpacityRoom) : Real{};
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
