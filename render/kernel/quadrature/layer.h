#pragma once
/// A ray segment through one piece of the transfer function, as a layer that emits light and attenuates its own light.
///
/// In w, the fraction of its optical depth D that is passed, a layer of source c(w) emits
///   int_0^1 c(w) D exp(-D w) dw = (1 - exp(-D)) c_seen.
/// c is linear in x, the HU's fraction of the piece, and the mean of x over w is known exactly. With
///   x(w) = mean + (x_end - x_begin) (w - 1/2) + g(w) - mean of g
/// all terms but g can be integrated. g is neglected. With s, the fraction of the segment in mm,
///   g = d(s) + (x_end - x_begin) (s - w),   |g| <= bend = max|d| + |x_end - x_begin| max|s - w|,
/// where d is the difference of the cubic x(s) from a straight line. g minus its mean has mean 0, so the error is at
/// most bend * int |D exp(-D w) - (1 - exp(-D))| dw, and that integral is at most min(D / 4, 2) (1 - exp(-D)): it is
/// twice the largest distance of the concave 1 - exp(-D w) from its chord. With a = D / 2 that distance is largest
/// where exp(a (1 - 2 w)) = sinh(a) / a, and ln(sinh(a) / a) <= a^2 / 6 makes it at most (D / 8) (1 - exp(-D)).

#include "render/kernel/attenuation.h"
#include "render/kernel/walk/masked_optics.h"

namespace pdr {

template <class Real>
struct Layer {
    Attenuation<Real> behind;
    Real fraction;  ///< position in the piece of the effective source of the layer
    Real bound;     ///< bound on the error of `fraction`
};

/// Returns `bend` of the bound at the top of this file. d has the Bernstein coefficients (0, d1, d2, 0), whose weights
/// are at most 3/4 together. w - s has those of degree four (0, w1, w2, w3, 0), at most 7/8 together, where w1, w1 + w2
/// .. are sums of (extinction - mean) / mean / 4.
template <class Real>
PDR_HD_INLINE Real bendOf(const OpticsAlong<Real>& along) {
    const Cubic<Real>& fraction = along.fraction;
    const Real d1 = fraction.b1 - (1.0f / 3) * (2.0f * fraction.b0 + fraction.b3);
    const Real d2 = fraction.b2 - (1.0f / 3) * (fraction.b0 + 2.0f * fraction.b3);
    const Real e0 = fraction.b0 - along.meanFraction, e1 = fraction.b1 - along.meanFraction;
    const Real e3 = fraction.b3 - along.meanFraction;
    const Real furthest = max(max(abs(e0), abs(e0 + e1)), abs(e3));
    const Real uneven =
        along.meanExtinction > 0.0f ? furthest * abs(along.extinctionRise) / along.meanExtinction : Real{};
    return 0.75f * max(abs(d1), abs(d2)) + (7.0f / 32) * abs(fraction.b3 - fraction.b0) * uneven;
}

/// The position of a segment's source in the piece.
template <class Real>
struct SourceAlong {
    Real fraction;  ///< mean along the segment, weighted by the extinction
    Real bend;      ///< see bendOf()
};

template <class Real>
PDR_HD_INLINE SourceAlong<Real> sourceAlong(const OpticsAlong<Real>& along) {
    return {extinctionWeightedFraction(along), bendOf(along)};
}

/// Returns the source of a segment that may be partly hidden; there |s - w| <= 1.
template <class Real>
PDR_HD_INLINE SourceAlong<Real> sourceAlong(const OpticsAlong<Real>& along, const Cubic<Real>& weight) {
    const SeenAlong<Real> seen = seenAlong(along, weight);
    const Cubic<Real>& fraction = along.fraction;
    const Real most = max(max(fraction.b0, fraction.b1), max(fraction.b2, fraction.b3));
    const Real least = min(min(fraction.b0, fraction.b1), min(fraction.b2, fraction.b3));
    const Real whole = bendOf(along);
    return {seenFraction(along, weight, seen), seen.partly ? 2.0f * (most - least) : whole};
}

template <class Real>
PDR_HD_INLINE Layer<Real> layerAlong(const OpticsAlong<Real>& along, Real depth, const SourceAlong<Real>& source) {
    const Attenuation<Real> behind = attenuation(depth);
    const Real early = (along.fraction.b3 - along.fraction.b0) * absorbedBeforeMiddle(depth, behind);
    return {behind, source.fraction - (depth > 0.0f ? early : Real{}), source.bend * min(0.25f * depth, Real{} + 2.0f)};
}

}  // namespace pdr
