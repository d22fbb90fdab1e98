#pragma once
/// The transfer function along a ray: in each piece, extinction and source are linear in the HU.

#include "render/kernel/flat_scene.h"
#include "render/kernel/walk/cubic.h"

namespace pdr {

template <class Real>
struct OpticsPiece {
    using Int = typename SimdTraits<Real>::Int;

    Int index;
    Real start, end;  ///< HU
};

template <class Real>
PDR_HD_INLINE Real opticsColumn(const FlatOptics& optics, int column, typename SimdTraits<Real>::Int index) {
    return tableLookup(optics.table + column * optics.stride, optics.stride, index);
}

/// Returns piece number `index` of the curve.
PDR_HD_INLINE OpticsPiece<float> opticsPiece(const FlatOptics& optics, int index) {
    return {index, opticsColumn<float>(optics, int(OpticsColumn::start), index),
            opticsColumn<float>(optics, int(OpticsColumn::end), index)};
}

/// Returns the piece of `curve` that a segment begins in. At a border, this is the piece that the segment continues in.
PDR_HD_INLINE OpticsPiece<float> pieceAtBegin(const FlatOptics& optics, const FlatTransferFunction& curve,
                                              const Cubic<float>& hu) {
    const bool falls = hu.b3 < hu.b0;
    // Interpolation leaves the range of voxels by less than 1 HU, which pieceAt allows for.
    int index = curve.firstPiece + curve.pieceAt[(int(hu.b0) + 32768) >> 4];
    float end = opticsColumn<float>(optics, int(OpticsColumn::end), index);
    while (falls ? hu.b0 > end : hu.b0 >= end)
        end = opticsColumn<float>(optics, int(OpticsColumn::end), ++index);
    return {index, opticsColumn<float>(optics, int(OpticsColumn::start), index), end};
}

#if !defined(__CUDACC__)

/// Returns the piece of each lane. It tries every piece, since curves have few and a look-up would gather.
PDR_HD_INLINE OpticsPiece<FloatLanes> pieceAtBegin(const FlatOptics& optics, const FlatTransferFunction& curve,
                                                   const Cubic<FloatLanes>& hu) {
    const IntLanes falls = hu.b3 < hu.b0;
    const float* starts = optics.table + int(OpticsColumn::start) * optics.stride + curve.firstPiece;
    const float* ends = optics.table + int(OpticsColumn::end) * optics.stride + curve.firstPiece;
    IntLanes index{};
    for (int i = 1; i < curve.pieceCount; ++i) {
        const float start = starts[i];
        const IntLanes reached = falls ? hu.b0 > start : hu.b0 >= start;
        index = reached ? IntLanes{} + i : index;
    }
    return {index + curve.firstPiece, tableLookup(starts, curve.pieceCount, index),
            tableLookup(ends, curve.pieceCount, index)};
}

#endif

/// A ray segment through one piece. HU are expressed as fractions of the piece, so that extinction and source are
/// linear in them.
template <class Real>
struct OpticsAlong {
    Cubic<Real> fraction;  ///< in [0, 1]
    Real meanFraction;
    Real extinction, extinctionRise;  ///< where the fraction is 0, and the change to where it is 1 [1/mm]
    Real meanExtinction;              ///< mean along the segment [1/mm]
};

template <class Real>
PDR_HD_INLINE OpticsAlong<Real> opticsAlong(const FlatOptics& optics, const OpticsPiece<Real>& piece,
                                            const Cubic<Real>& hu) {
    const auto column = [&](OpticsColumn which) { return opticsColumn<Real>(optics, int(which), piece.index); };
    const Real perHu = column(OpticsColumn::perHu);
    // The first piece starts at -infinity and has 0 per HU: there the product is not a number, and all fractions are 0.
    const auto fraction = [&](Real value) {
        return lesser(greater((value - piece.start) * perHu, Real{}), Real{} + 1.0f);
    };
    OpticsAlong<Real> along;
    along.fraction = {fraction(hu.b0), fraction(hu.b1), fraction(hu.b2), fraction(hu.b3)};
    along.meanFraction = along.fraction.mean();
    along.extinction = column(OpticsColumn::extinction);
    along.extinctionRise = column(OpticsColumn::extinctionRise);
    along.meanExtinction = greater(along.extinction + along.extinctionRise * along.meanFraction, Real{});
    return along;
}

/// Returns the mean fraction along a segment, weighted by the extinction: mean + rise * variance / mean extinction,
/// exactly. The variance of a cubic is a quadratic form of its coefficients' differences from their mean.
template <class Real>
PDR_HD_INLINE Real extinctionWeightedFraction(const OpticsAlong<Real>& along) {
    const Real a = along.fraction.b0 - along.meanFraction, b = along.fraction.b1 - along.meanFraction,
               c = along.fraction.b2 - along.meanFraction, d = along.fraction.b3 - along.meanFraction;
    const Real variance = (1.0f / 7) * (a * a + d * d + 0.6f * (b * b + c * c) + a * b + c * d +
                                        0.4f * (a * c + b * d) + 0.1f * a * d + 0.9f * b * c);
    const Real shift = along.meanExtinction > 0.0f ? along.extinctionRise * variance / along.meanExtinction : Real{};
    return max(min(along.meanFraction + shift, Real{} + 1.0f), Real{});
}

}  // namespace pdr
