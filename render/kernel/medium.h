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
    // Most cells have one or two curves.
    const std::uint8_t one = corners.curve[0];
    std::uint8_t other = one;
    for (int n = 1; n < 8; ++n)
        other = corners.curve[n] != one ? corners.curve[n] : other;
    const float ofOne = extinctionOf(scene.parts.curves[one], hu);
    const float ofOther = extinctionOf(scene.parts.curves[other], hu);
    VoxelCell<float> extinctions{};
    bool more = false;
    for (int n = 0; n < 8; ++n) {
        extinctions.hu[n] = corners.curve[n] == one ? ofOne : ofOther;
        more |= (corners.curve[n] != one) & (corners.curve[n] != other);
    }
    for (int n = 1; more && n < 8; ++n)
        if (corners.curve[n] != one && corners.curve[n] != other)
            extinctions.hu[n] = extinctionOf(scene.parts.curves[corners.curve[n]], hu);
    return extinctions;
}

/// Returns the extinction at a place with `hu` in a cell whose corners have these labels, of several curves [1/mm].
PDR_HD inline float mixedExtinction(const FlatScene& scene, std::uint64_t labels, vec3 fraction, float hu) {
    return trilinear(cornerExtinctions(scene, cornerCurves(scene, labels), hu), fraction);
}

/// Returns the extinction at a position with `hu` where parts have curves of their own [1/mm].
PDR_HD inline float partedExtinction(const FlatScene& scene, vec3 position, float hu) {
    const auto [corner, fraction] = placeInCell(scene.volume, position);
    std::uint64_t labels{};
    const int only = onlyCurve(scene, corner, labels);
    return only == kSeveralCurves ? mixedExtinction(scene, labels, fraction, hu)
                                  : extinctionOf(scene.parts.curves[only], hu);
}
PDR_HD_INLINE float partedExtinction(const FlatScene& scene, vec3 position, float hu, bool mask) {
    return mask ? partedExtinction(scene, position, hu) : 0.0f;
}

#if !defined(__CUDACC__)

/// Returns it in the lanes of `mask`.
inline FloatLanes partedExtinction(const FlatScene& scene, const Vec3<FloatLanes>& position, FloatLanes hu,
                                   IntLanes mask) {
    const auto clamped = [](FloatLanes at, float high) { return min(max(at, FloatLanes{}), FloatLanes{} + high); };
    const vec3 end = scene.volume.lastIndex, last = scene.volume.lastCorner;
    const Vec3<FloatLanes> at{clamped(position.x, end.x), clamped(position.y, end.y), clamped(position.z, end.z)};
    const Vec3<IntLanes> corner{toInt(min(at.x, FloatLanes{} + last.x)), toInt(min(at.y, FloatLanes{} + last.y)),
                                toInt(min(at.z, FloatLanes{} + last.z))};
    BitsLanes labels{};
    const IntLanes only = onlyCurve(scene, corner, mask, labels);
    const Vec3<FloatLanes> fraction{at.x - toFloat(corner.x), at.y - toFloat(corner.y), at.z - toFloat(corner.z)};
    FloatLanes extinction{};
    forCurvesOfLanes(
        only, mask,
        [&](int curve, IntLanes same) {
            const FloatLanes ofCurve = extinctionOf(scene.parts.curves[curve], hu);
            extinction = same ? ofCurve : extinction;
        },
        [&](int lane) {
            extinction[lane] = only[lane] == kSeveralCurves
                                   ? mixedExtinction(scene, labels[lane],
                                                     {fraction.x[lane], fraction.y[lane], fraction.z[lane]}, hu[lane])
                                   : extinctionOf(scene.parts.curves[only[lane]], hu[lane]);
        });
    return extinction;
}

#endif

/// Returns the extinction at a `position` (index space) with `hu` [1/mm], where `mask` holds: that of the tissue times
/// its visibility weight.
template <class Real>
PDR_HD_INLINE Real extinction(const FlatScene& scene, const Vec3<Real>& position, Real hu,
                              typename SimdTraits<Real>::Mask mask) {
    const Real whole =
        hasParts(scene) ? partedExtinction(scene, position, hu, mask) : extinctionOf(scene.transferFunction, hu);
    return isMasked(scene) ? whole * weightAt(scene, position) : whole;
}

PDR_HD_INLINE float extinction(const FlatScene& scene, vec3 position) {
    return extinction(scene, position, hounsfield(scene.volume, position), true);
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
    std::uint64_t labels{};
    if (scene.parts.colours)
        labels = cornerLabels(scene, place.corner);
    else if (const int only = onlyCurve(scene, place.corner, labels); only != kSeveralCurves)
        return scene.parts.curves[only];
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
