#pragma once
/// The Henyey-Greenstein phase function [1/sr]; Henyey & Greenstein 1941. cosTheta is between the directions of travel:
/// +1 is straight on. The forms are stable: no cancellation at cosTheta near +-1 nor at g near 0 or +-1.

#include "render/kernel/turns.h"

namespace pdr {

inline constexpr float kInverseFourPi = 1 / (4 * kPi);

/// Returns the pdf of light from `wi` being scattered to `wo`; unit vectors that point away from the event.
PDR_HD inline float phaseEval(float g, vec3 wo, vec3 wi) {
    const float a = std::fabs(g);
    // Half the square of this is 1 - cos of the angle to the peak, which lies behind for g < 0.
    const vec3 fromPeak = g < 0 ? wi - wo : wi + wo;
    const float denominator = (1 - a) * (1 - a) + a * glm::dot(fromPeak, fromPeak);
    return kInverseFourPi * (1 - a) * (1 + a) / (denominator * std::sqrt(denominator));
}

/// Computes two unit vectors that form a right-handed frame with the unit vector n; Duff et al. 2017.
PDR_HD inline void orthonormalBasis(vec3 n, vec3& s, vec3& t) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1 / (sign + n.z);
    const float b = n.x * n.y * a;
    s = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    t = {b, sign + n.y * n.y * a, -n.y};
}

/// Returns the point of the unit circle at the angle `turns` from s towards t.
PDR_HD inline vec3 circlePoint(vec3 s, vec3 t, float turns) {
    const CirclePoint<float> point = circlePoint(turns);
    return s * point.cosine + t * point.sine;
}

/// Samples a direction `wi` from which light is scattered to `wo`, distributed as phaseEval.
PDR_HD inline vec3 phaseSample(float g, vec3 wo, vec2 u) {
    const vec3 onward = -wo;
    const float a = std::fabs(g);
    const float d = (1 - a) + 2 * a * u.x;
    float oneMinusCos = 2 * (1 - a) * (1 - a) * (1 - u.x) * (1 + a * u.x) / (d * d);
    float onePlusCos = 2 * (1 + a) * (1 + a) * u.x * ((1 - a) + a * u.x) / (d * d);
    if (g < 0) {
        const float swap = oneMinusCos;
        oneMinusCos = onePlusCos;
        onePlusCos = swap;
    }
    const float cosine = 0.5f * (onePlusCos - oneMinusCos);
    const float sine = std::sqrt(oneMinusCos * onePlusCos);
    vec3 s, t;
    orthonormalBasis(onward, s, t);
    return onward * cosine + circlePoint(s, t, u.y) * sine;
}

}  // namespace pdr
