#pragma once
/// The Henyey-Greenstein phase function [1/sr]; Henyey & Greenstein 1941. cosTheta is between the directions of travel:
/// +1 is straight on. The forms are stable: no cancellation at cosTheta near +-1 nor at g near 0 or +-1.

#include "render/kernel/turns.h"

namespace pdr {

inline constexpr float kInverseFourPi = 1 / (4 * kPi);

/// Returns the pdf of light from `wi` being scattered to `wo`; unit vectors that point away from the event.
template <class Real>
PDR_HD inline Real phaseEval(float g, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    const float a = std::fabs(g);
    // Half the square of this is 1 - cos of the angle to the peak, which lies behind for g < 0.
    const Vec3<Real> fromPeak = g < 0 ? wi - wo : wi + wo;
    const Real denominator = (1 - a) * (1 - a) + a * dot(fromPeak, fromPeak);
    return kInverseFourPi * (1 - a) * (1 + a) / (denominator * squareRoot(denominator));
}

/// Computes two unit vectors that form a right-handed frame with the unit vector n; Duff et al. 2017.
template <class Real>
PDR_HD inline void orthonormalBasis(const Vec3<Real>& n, Vec3<Real>& s, Vec3<Real>& t) {
    const Real sign = signOf(n.z);
    const Real a = -1.0f / (sign + n.z);
    const Real b = n.x * n.y * a;
    s = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    t = {b, sign + n.y * n.y * a, -n.y};
}

/// Returns the point of the unit circle at the angle `turns` from s towards t.
template <class Real>
PDR_HD inline Vec3<Real> circlePoint(const Vec3<Real>& s, const Vec3<Real>& t, Real turns) {
    const CirclePoint<Real> point = circlePoint(turns);
    return s * point.cosine + t * point.sine;
}

/// Samples a direction `wi` from which light is scattered to `wo`, distributed as phaseEval.
template <class Real>
PDR_HD inline Vec3<Real> phaseSample(float g, const Vec3<Real>& wo, const Vec2<Real>& u) {
    const Vec3<Real> onward = -wo;
    const float a = std::fabs(g);
    const Real d = (1 - a) + 2 * a * u.x;
    Real oneMinusCos = 2 * (1 - a) * (1 - a) * (1.0f - u.x) * (1.0f + a * u.x) / (d * d);
    Real onePlusCos = 2 * (1 + a) * (1 + a) * u.x * ((1 - a) + a * u.x) / (d * d);
    if (g < 0) {
        const Real swap = oneMinusCos;
        oneMinusCos = onePlusCos;
        onePlusCos = swap;
    }
    const Real cosine = 0.5f * (onePlusCos - oneMinusCos);
    const Real sine = squareRoot(oneMinusCos * onePlusCos);
    Vec3<Real> s, t;
    orthonormalBasis(onward, s, t);
    return onward * cosine + circlePoint(s, t, u.y) * sine;
}

}  // namespace pdr
