#pragma once
/// Light that tissue gives off along a segment through parts, where curves with sources of their own meet. The
/// extinction there is that of parted_optics.h. Light per mm is that of the corners' curves, extinction times source,
/// mixed by the same weights. For each corner it is a quadratic in the HU; its chord over the HU of the segment makes
/// it
///   light(s) = base(s) + slope(s) (hu(s) - hu(0))
/// as the extinction is, and differs by at most a quarter of the product of both changes.
///
/// With c the mean source, light / extinction, q = light - c extinction has no integral along the segment. Seen through
/// the segment's own optical depth D, whose transmittance T lies between exp(-D) and 1,
///   int light T ds = c (1 - exp(-D)) + int q (T - (1 + exp(-D)) / 2) ds,
/// and the last term is at most (1 - exp(-D)) / 2 times the length and the largest |q|: second order in the length.

#include "render/kernel/walk/piece_walk.h"

namespace pdr {

/// Light per mm of the curves at the corners of a cell with several, for each channel.
template <class Real>
struct CornerLight {
    VoxelCell<Real> base[3];   ///< at the HU where a segment begins
    VoxelCell<Real> slope[3];  ///< change per HU
    Real chord[3]{};           ///< bound on the error of these lines
};

/// Returns the light of the corners' curves on a segment that crosses no border of a piece of any of them.
PDR_HD inline CornerLight<float> cornerLight(const FlatScene& scene, ivec3 corner, const Cubic<float>& hu) {
    const FlatOptics& optics = scene.optics;
    const CornerCurves corners = cornerCurves(scene, corner);
    const float low = hu.lowest(), range = hu.highest() - low;
    const float perRange = range > 0.0f ? 1.0f / range : 0.0f;
    CornerLight<float> light{};
    for (int n = 0; n < 8; ++n) {
        int same = 0;
        while (corners.curve[same] != corners.curve[n])
            ++same;
        if (same < n) {
            for (int channel = 0; channel < 3; ++channel) {
                light.base[channel].hu[n] = light.base[channel].hu[same];
                light.slope[channel].hu[n] = light.slope[channel].hu[same];
            }
            continue;
        }
        const OpticsPiece<float> piece = pieceAtBegin(optics, scene.parts.curves[corners.curve[n]], hu);
        const auto column = [&](int which) { return opticsColumn<float>(optics, which, piece.index); };
        // As in opticsAlong(): the first piece's product is not a number, and its fractions are 0.
        const float perHu = column(int(OpticsColumn::perHu));
        const auto fraction = [&](float value) { return lesser(greater((value - piece.start) * perHu, 0.0f), 1.0f); };
        const float first = fraction(low), last = fraction(low + range);
        const float extinction = column(int(OpticsColumn::extinction)),
                    rise = column(int(OpticsColumn::extinctionRise));
        const float atLow = greater(extinction + rise * first, 0.0f), atHigh = greater(extinction + rise * last, 0.0f);
        for (int channel = 0; channel < 3; ++channel) {
            const float source = column(int(OpticsColumn::source) + channel),
                        sourceRise = column(int(OpticsColumn::sourceRise) + channel);
            const float begin = source + sourceRise * first, end = source + sourceRise * last;
            const float slope = (atHigh * end - atLow * begin) * perRange;
            light.base[channel].hu[n] = atLow * begin + slope * (hu.b0 - low);
            light.slope[channel].hu[n] = slope;
            const float chord = 0.25f * abs((atHigh - atLow) * (end - begin));
            light.chord[channel] = greater(light.chord[channel], chord);
        }
    }
    return light;
}

PDR_HD_INLINE void findCornerLight(const FlatScene& scene, const Vec3<int>& corner, bool mask, const Cubic<float>& hu,
                                   CornerLight<float>& found) {
    if (mask)
        found = cornerLight(scene, ivec3(corner.x, corner.y, corner.z), hu);
}

#if !defined(__CUDACC__)

/// Finds the same in the lanes of `mask`, one after the other, as findCornerPieces() does.
inline void findCornerLight(const FlatScene& scene, const Vec3<IntLanes>& corner, IntLanes mask,
                            const Cubic<FloatLanes>& hu, CornerLight<FloatLanes>& found) {
    for (int lane = 0; lane < kLanes; ++lane) {
        if (!mask[lane])
            continue;
        const CornerLight<float> one = cornerLight(scene, ivec3(corner.x[lane], corner.y[lane], corner.z[lane]),
                                                   {hu.b0[lane], hu.b1[lane], hu.b2[lane], hu.b3[lane]});
        for (int channel = 0; channel < 3; ++channel) {
            for (int n = 0; n < 8; ++n) {
                found.base[channel].hu[n][lane] = one.base[channel].hu[n];
                found.slope[channel].hu[n][lane] = one.slope[channel].hu[n];
            }
            found.chord[channel][lane] = one.chord[channel];
        }
    }
}

#endif

/// What a segment of several curves gives off in one channel.
template <class Real>
struct MixedSource {
    Real mean;    ///< radiance per optical depth
    Real uneven;  ///< bound on |light - mean * extinction| anywhere along it [1/mm]
};

/// Returns the largest magnitude of a cubic's coefficients, which none of its values exceeds.
template <class Real>
PDR_HD_INLINE Real largest(const Cubic<Real>& cubic) {
    return greater(greater(abs(cubic.b0), abs(cubic.b1)), greater(abs(cubic.b2), abs(cubic.b3)));
}

/// Returns a - factor * b.
template <class Real>
PDR_HD_INLINE Cubic<Real> without(const Cubic<Real>& a, Real factor, const Cubic<Real>& b) {
    return {a.b0 - factor * b.b0, a.b1 - factor * b.b1, a.b2 - factor * b.b2, a.b3 - factor * b.b3};
}

/// Returns the source of a segment of several curves. `meanExtinction`: its mean of the visible extinction.
template <class Real>
PDR_HD_INLINE MixedSource<Real> mixedSource(const CornerLight<Real>& corners, int channel,
                                            const PartedPieceOfWay<Real>& way, Real meanExtinction) {
    const Cubic<Real> base = hounsfieldAlong(corners.base[channel], way.from, way.to);
    const Cubic<Real> slope = hounsfieldAlong(corners.slope[channel], way.from, way.to);
    const Cubic<Real> rise{Real{}, way.hu.b1 - way.hu.b0, way.hu.b2 - way.hu.b0, way.hu.b3 - way.hu.b0};
    Real light = greater(base.mean() + meanOfProduct(slope, rise), Real{});
    if (way.masked) {
        light = Real{};
        for (int i = 0; i < kGaussPlaces; ++i) {
            const Real s = Real{} + gaussPlace(i).place;
            const Real here = greater(base.at(s) + slope.at(s) * rise.at(s), Real{});
            light = light + gaussPlace(i).share * (here * greater(way.weight.at(s), Real{}));
        }
    }
    const Real mean = meanExtinction > 0.0f ? light / meanExtinction : Real{};
    return {mean, largest(without(base, mean, way.mixed.base)) +
                      largest(without(slope, mean, way.mixed.slope)) * largest(rise)};
}

}  // namespace pdr
