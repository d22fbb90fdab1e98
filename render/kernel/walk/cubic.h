#pragma once
/// A cubic polynomial over [0, 1] by its Bernstein coefficients: it runs from b0 to b3 and stays between the smallest
/// and the largest of the four, and where they rise or fall, so does it (Farin, Curves and Surfaces for CAGD).

#include "render/base/lanes.h"

namespace pdr {

template <class Real>
PDR_HD inline Real abs(Real x) {
    return max(x, -x);
}

/// Where in [0, 1] a monotone function that runs from `first` to `last` has the value `level` between them; lanes
/// outside `mask` are left out. Newton's method inside a bracket that only ever shrinks.
///   Function   at(s), and its derivative slopeAt(s)
template <class Real, class Function>
PDR_HD_INLINE Real whereMonotoneIs(const Function& function, Real level, Real first, Real last,
                                   typename SimdTraits<Real>::Mask mask) {
    using Mask = typename SimdTraits<Real>::Mask;
    constexpr int kMostSteps = 32;
    // A step of Newton's method leaves at most |curvature| step^2 / 2, which is below the rounding of the values here.
    constexpr float kSettled = 1e-4f;
    constexpr float kNarrowest = 1e-7f;
    const Mask rises = last > first;
    Real low{}, high = Real{} + 1.0f;
    Real s = max(min((level - first) / (last - first), high), low);
    Mask open = mask;
    for (int i = 0; i < kMostSteps && any(open); ++i) {
        const Real beyond = function.at(s) - level;
        const Mask tooFar = rises ? beyond > 0.0f : beyond < 0.0f;
        high = tooFar ? s : high;
        low = tooFar ? low : s;
        const Real newton = s - beyond / function.slopeAt(s);
        const Mask inside = (newton >= low) & (newton <= high);
        const Real next = inside ? newton : 0.5f * (low + high);
        const Mask settled = (inside & (abs(next - s) <= kSettled)) | (high - low <= kNarrowest);
        s = open ? next : s;
        open = open & !settled;
    }
    return s;
}

template <class Real>
struct Cubic {
    using Mask = typename SimdTraits<Real>::Mask;
    Real b0, b1, b2, b3;

    /// Where `mask` holds it becomes `other`.
    PDR_HD_INLINE void take(Mask mask, const Cubic& other) {
        b0 = mask ? other.b0 : b0;
        b1 = mask ? other.b1 : b1;
        b2 = mask ? other.b2 : b2;
        b3 = mask ? other.b3 : b3;
    }

    PDR_HD_INLINE Real lowest() const { return min(min(b0, b1), min(b2, b3)); }
    PDR_HD_INLINE Real highest() const { return max(max(b0, b1), max(b2, b3)); }
    PDR_HD_INLINE Real mean() const { return 0.25f * ((b0 + b1) + (b2 + b3)); }

    PDR_HD_INLINE Mask monotone() const {
        return ((b0 <= b1) & (b1 <= b2) & (b2 <= b3)) | ((b0 >= b1) & (b1 >= b2) & (b2 >= b3));
    }

    PDR_HD_INLINE Real at(Real s) const {
        const Real r = 1.0f - s;
        return r * r * (r * b0 + 3.0f * s * b1) + s * s * (3.0f * r * b2 + s * b3);
    }

    PDR_HD_INLINE Real slopeAt(Real s) const {
        const Real r = 1.0f - s;
        return 3.0f * (r * r * (b1 - b0) + 2.0f * r * s * (b2 - b1) + s * s * (b3 - b2));
    }

    /// The parts before and behind s, each over [0, 1] again (de Casteljau).
    PDR_HD_INLINE void split(Real s, Cubic& before, Cubic& behind) const {
        const Real m01 = b0 + (b1 - b0) * s, m12 = b1 + (b2 - b1) * s, m23 = b2 + (b3 - b2) * s;
        const Real m012 = m01 + (m12 - m01) * s, m123 = m12 + (m23 - m12) * s;
        const Real m = m012 + (m123 - m012) * s;
        before = {b0, m01, m012, m};
        behind = {m, m123, m23, b3};
    }

    /// Its largest value: at an end or where the slope is 0, d0 (1-s)^2 + 2 d1 s (1-s) + d2 s^2 = 0.
    PDR_HD_INLINE Real maximum() const {
        const Real d0 = b1 - b0, d1 = b2 - b1, d2 = b3 - b2;
        const Real curve = d0 - 2.0f * d1 + d2, half = d1 - d0;
        const Real root = squareRoot(max(d1 * d1 - d0 * d2, Real{}));
        const Real q = half > 0.0f ? -half - root : root - half;
        // A place outside, or none at all, becomes an end; so the value is met wherever the places are.
        const auto inside = [](Real s) { return max(min(s, Real{} + 1.0f), Real{}); };
        return max(max(b0, b3), max(at(inside(q / curve)), at(inside(d0 / q))));
    }

    /// Where a monotone cubic has the value `level`, which lies between b0 and b3; lanes outside `mask` are left out.
    PDR_HD_INLINE Real whereIs(Real level, Mask mask) const { return whereMonotoneIs(*this, level, b0, b3, mask); }
};

}  // namespace pdr
