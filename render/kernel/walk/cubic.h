#pragma once
/// A cubic polynomial over [0, 1] by its Bernstein coefficients. It runs from b0 to b3, stays between the smallest and
/// the largest of the four, and is monotone where they are (Farin, Curves and Surfaces for CAGD).

#include "render/base/extremes.h"

namespace pdr {

/// Returns the magnitude of a number; of 0, with either sign.
template <class Real>
PDR_HD inline Real abs(Real x) {
#if defined(__CUDA_ARCH__)
    return fabsf(x);
#else
    return max(x, -x);
#endif
}

/// Returns where in [0, 1] a monotone function that runs from `first` to `last` has the value `level`, which lies
/// between them. Lanes outside `mask` are ignored. Newton's method inside a bracket that only shrinks.
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
    Real s = greater(lesser((level - first) / (last - first), high), low);
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

    /// Assigns `other` where `mask` holds.
    PDR_HD_INLINE void take(Mask mask, const Cubic& other) {
        b0 = mask ? other.b0 : b0;
        b1 = mask ? other.b1 : b1;
        b2 = mask ? other.b2 : b2;
        b3 = mask ? other.b3 : b3;
    }

    PDR_HD_INLINE Real lowest() const { return lesser(lesser(b0, b1), lesser(b2, b3)); }
    PDR_HD_INLINE Real highest() const { return greater(greater(b0, b1), greater(b2, b3)); }
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

    /// Splits the cubic into the parts before and behind s, each over [0, 1] again (de Casteljau).
    PDR_HD_INLINE void split(Real s, Cubic& before, Cubic& behind) const {
        const Real m01 = b0 + (b1 - b0) * s, m12 = b1 + (b2 - b1) * s, m23 = b2 + (b3 - b2) * s;
        const Real m012 = m01 + (m12 - m01) * s, m123 = m12 + (m23 - m12) * s;
        const Real m = m012 + (m123 - m012) * s;
        before = {b0, m01, m012, m};
        behind = {m, m123, m23, b3};
    }

    /// Returns the largest value. It is at an end or where the slope is 0: d0 (1-s)^2 + 2 d1 s (1-s) + d2 s^2 = 0.
    PDR_HD_INLINE Real maximum() const {
        const Real d0 = b1 - b0, d1 = b2 - b1, d2 = b3 - b2;
        const Real curve = d0 - 2.0f * d1 + d2, half = d1 - d0;
        const Real root = squareRoot(max(d1 * d1 - d0 * d2, Real{}));
        const Real q = half > 0.0f ? -half - root : root - half;
        // A root outside [0, 1], or NaN, becomes an end, so that every candidate is a value of the cubic.
        const auto inside = [](Real s) { return max(min(s, Real{} + 1.0f), Real{}); };
        return max(max(b0, b3), max(at(inside(q / curve)), at(inside(d0 / q))));
    }

    /// Returns where a monotone cubic has the value `level`, which lies between b0 and b3. Lanes outside `mask` are
    /// ignored.
    PDR_HD_INLINE Real whereIs(Real level, Mask mask) const { return whereMonotoneIs(*this, level, b0, b3, mask); }
};

/// Returns the mean over [0, 1] of the product of two cubics: exactly, by that of each pair of Bernstein polynomials.
template <class Real>
PDR_HD_INLINE Real meanOfProduct(const Cubic<Real>& a, const Cubic<Real>& b) {
    const Real sum = b.b0 * (a.b0 + 0.5f * a.b1 + 0.2f * a.b2 + 0.05f * a.b3) +
                     b.b1 * (0.5f * a.b0 + 0.6f * a.b1 + 0.45f * a.b2 + 0.2f * a.b3) +
                     b.b2 * (0.2f * a.b0 + 0.45f * a.b1 + 0.6f * a.b2 + 0.5f * a.b3) +
                     b.b3 * (0.05f * a.b0 + 0.2f * a.b1 + 0.5f * a.b2 + a.b3);
    return sum * (1.0f / 7);
}

}  // namespace pdr
