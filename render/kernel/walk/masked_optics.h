#pragma once
/// A ray segment through one piece of the curve that may be partly hidden: its extinction is that of the tissue times a
/// visibility weight. HU, and with them extinction and source, are cubic polynomials along the segment, and so is the
/// weight. Products of three of them have degree nine, which Gauss's rule of five points integrates exactly. Where all
/// of a segment is visible, the numbers are those of a scene without a mask, bit by bit.

#include "render/kernel/walk/optics.h"

namespace pdr {

/// A point of the Gauss-Legendre rule on [0, 1]: the sum of share * f(place) is the integral of f up to degree nine.
struct GaussPlace {
    float place, share;
};
inline constexpr int kGaussPlaces = 5;
PDR_HD inline GaussPlace gaussPlace(int i) {
    constexpr GaussPlace kPlaces[kGaussPlaces] = {{0.0469100770f, 0.1184634425f},
                                                  {0.2307653449f, 0.2393143352f},
                                                  {0.5f, 0.2844444444f},
                                                  {0.7692346551f, 0.2393143352f},
                                                  {0.9530899230f, 0.1184634425f}};
    return kPlaces[i];
}

/// Returns the extinction at the fraction `s` of a segment [1/mm].
template <class Real>
PDR_HD_INLINE Real extinctionAt(const OpticsAlong<Real>& along, Real s) {
    return max(along.extinction + along.extinctionRise * along.fraction.at(s), Real{});
}

/// The visible part of a segment.
template <class Real>
struct SeenAlong {
    typename SimdTraits<Real>::Mask partly;  ///< some of the segment is hidden
    Real meanExtinction;                     ///< mean along the segment of extinction times weight [1/mm]
};

template <class Real>
PDR_HD_INLINE SeenAlong<Real> seenAlong(const OpticsAlong<Real>& along, const Cubic<Real>& weight) {
    SeenAlong<Real> seen{weight.lowest() < 1.0f, along.meanExtinction};
    if (!any(seen.partly))
        return seen;
    Real mean{};
    for (int i = 0; i < kGaussPlaces; ++i) {
        const Real s = Real{} + gaussPlace(i).place;
        mean = mean + gaussPlace(i).share * (extinctionAt(along, s) * max(weight.at(s), Real{}));
    }
    seen.meanExtinction = seen.partly ? mean : seen.meanExtinction;
    return seen;
}

/// Returns extinctionWeightedFraction() for the visible extinction that `seen` describes.
template <class Real>
PDR_HD_INLINE Real seenFraction(const OpticsAlong<Real>& along, const Cubic<Real>& weight,
                                const SeenAlong<Real>& seen) {
    const Real whole = extinctionWeightedFraction(along);
    if (!any(seen.partly))
        return whole;
    Real sum{};
    for (int i = 0; i < kGaussPlaces; ++i) {
        const Real s = Real{} + gaussPlace(i).place;
        const Real extinction = extinctionAt(along, s) * max(weight.at(s), Real{});
        sum = sum + gaussPlace(i).share * (extinction * along.fraction.at(s));
    }
    const Real partly = seen.meanExtinction > 0.0f ? sum / seen.meanExtinction : along.meanFraction;
    return seen.partly ? max(min(partly, Real{} + 1.0f), Real{}) : whole;
}

/// The visible extinction along a partly visible segment.
template <class Real>
struct SeenExtinction {
    const OpticsAlong<Real>& along;
    const Cubic<Real>& weight;

    PDR_HD_INLINE Real at(Real s) const { return extinctionAt(along, s) * max(weight.at(s), Real{}); }
};

/// The optical depth from 0 to s in [0, 1] of a segment whose extinction is a polynomial of degree nine at most, in
/// units of the whole segment's depth.
template <class Real, class Extinction>
struct DepthPassedByGauss {
    const Extinction& extinction;
    Real scale;  ///< 1 / mean extinction

    PDR_HD_INLINE Real at(Real s) const {
        Real passed{};
        for (int i = 0; i < kGaussPlaces; ++i)
            passed = passed + gaussPlace(i).share * slopeAt(s * gaussPlace(i).place);
        return s * passed;
    }
    PDR_HD_INLINE Real slopeAt(Real s) const { return extinction.at(s) * scale; }
};

}  // namespace pdr
