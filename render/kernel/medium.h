#pragma once
/// The medium: opacity, extinction and material as functions of the HU.

#include "render/kernel/mask.h"
#include "render/kernel/parts.h"

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

/// Where a position lies between voxels: the lowest corner of its cell, and the fractions of the cell.
struct PlaceInCell {
    ivec3 corner;
    vec3 fraction;
};

PDR_HD inline PlaceInCell placeInCell(const FlatGrid& volume, vec3 position) {
    const vec3 inside = glm::min(glm::max(position, vec3(0)), volume.lastIndex);
    const ivec3 corner(glm::min(inside, volume.lastCorner));
    return {corner, inside - vec3(corner)};
}

/// Returns the extinction of each corner's curve at `hu` [1/mm].
PDR_HD inline VoxelCell<float> cornerExtinctions(const FlatScene& scene, const CornerCurves& corners, float hu) {
    VoxelCell<float> extinctions{};
    for (int n = 0; n < 8; ++n) {
        int same = 0;  // most cells have few curves
        while (corners.curve[same] != corners.curve[n])
            ++same;
        extinctions.hu[n] = same < n ? extinctions.hu[same] : extinctionOf(scene.parts.curves[corners.curve[n]], hu);
    }
    return extinctions;
}

/// Returns the extinction at a place with `hu` in a cell whose corners have several curves [1/mm].
PDR_HD inline float mixedExtinction(const FlatScene& scene, const PlaceInCell& place, float hu) {
    const VoxelCell<float> corners = cornerExtinctions(scene, cornerCurves(scene, place.corner), hu);
    return trilinear(corners, {place.fraction.x, place.fraction.y, place.fraction.z});
}

/// Returns the extinction at a position with `hu` where parts have curves of their own [1/mm].
PDR_HD inline float partedExtinction(const FlatScene& scene, vec3 position, float hu) {
    const PlaceInCell place = placeInCell(scene.volume, position);
    const int only = onlyCurve(scene, place.corner);
    return only == kSeveralCurves ? mixedExtinction(scene, place, hu) : extinctionOf(scene.parts.curves[only], hu);
}

#if !defined(__CUDACC__)

/// In lanes, cells with several curves are served one after the other: few are.
inline FloatLanes partedExtinction(const FlatScene& scene, const Vec3<FloatLanes>& position, FloatLanes hu) {
    const auto corner = [](FloatLanes at, float last) {
        return toInt(min(max(at, FloatLanes{}), FloatLanes{} + last));
    };
    const vec3 last = scene.volume.lastCorner;
    const Vec3<IntLanes> cell{corner(position.x, last.x), corner(position.y, last.y), corner(position.z, last.z)};
    const IntLanes only = onlyCurve(scene, cell, ~IntLanes{}), several = only == kSeveralCurves;
    FloatLanes extinction{};
    forEachCurve(only, ~several, [&](int curve, IntLanes here) {
        const FloatLanes ofCurve = extinctionOf(scene.parts.curves[curve], hu);
        extinction = here ? ofCurve : extinction;
    });
    for (int lane = 0; any(several) && lane < kLanes; ++lane)
        if (several[lane]) {
            const vec3 at(position.x[lane], position.y[lane], position.z[lane]);
            extinction[lane] = mixedExtinction(scene, placeInCell(scene.volume, at), hu[lane]);
        }
    return extinction;
}

#endif

/// Returns the extinction at a `position` (index space) with `hu` [1/mm]: that of the tissue times its visibility
/// weight.
template <class Real>
PDR_HD_INLINE Real extinction(const FlatScene& scene, const Vec3<Real>& position, Real hu) {
    const Real whole =
        hasParts(scene) ? partedExtinction(scene, position, hu) : extinctionOf(scene.transferFunction, hu);
    return isMasked(scene) ? whole * weightAt(scene, position) : whole;
}

template <class Real>
PDR_HD_INLINE Real extinction(const FlatScene& scene, const Vec3<Real>& position) {
    return extinction(scene, position, hounsfield(scene.volume, position));
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

/// Returns the curve whose tissue light meets at `position` (index space), where the HU are `hu`: each curve with the
/// probability of its share of the extinction. `u` decides, and is uniform again afterwards.
PDR_HD_INLINE FlatTransferFunction curveMet(const FlatScene& scene, vec3 position, float hu, float& u) {
    if (!hasParts(scene))
        return scene.transferFunction;
    const PlaceInCell place = placeInCell(scene.volume, position);
    if (!scene.parts.colours)
        if (const int only = onlyCurve(scene, place.corner); only != kSeveralCurves)
            return scene.parts.curves[only];
    const std::uint64_t labels = cornerLabels(scene, place.corner);
    if (isOneMaterial(scene, labels))
        return scene.parts.curves[materialAt(scene, labels, 0)];
    const CornerCurves corners = cornerCurves(scene, labels);
    const VoxelCell<float> extinctions = cornerExtinctions(scene, corners, hu);
    const vec3 f = place.fraction;
    float shares[8], sum = 0;
    for (int n = 0; n < 8; ++n) {
        shares[n] = extinctions.hu[n] * (n & 1 ? f.x : 1 - f.x) * (n & 2 ? f.y : 1 - f.y) * (n & 4 ? f.z : 1 - f.z);
        sum += shares[n];
    }
    float left = u * sum;
    int met = 0;
    for (int n = 0; n < 8; ++n)
        if (shares[n] > 0) {
            met = n;
            if (left < shares[n])
                break;
            left -= shares[n];
        }
    if (shares[met] > 0)
        u = glm::min(left / shares[met], 1 - 0x1p-24f);
    return scene.parts.curves[materialAt(scene, labels, met)];
}

}  // namespace pdr
