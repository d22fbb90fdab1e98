#pragma once
/// Angles in turns: 1 is the full circle, so that reducing an angle to an eighth of a turn needs no rounding. The
/// arithmetic is the same on every device, so that devices agree bit by bit.

#include "render/base/lanes.h"

namespace pdr {

template <class Real>
struct CirclePoint {
    Real cosine, sine;
};

/// Returns the point of the unit circle at the angle `turns`, for |turns| <= 2^20. Errors are below 1e-7; for small
/// sines the relative error is below 1.5e-7. Uses the Taylor series up to an eighth of a turn.
template <class Real>
PDR_HD inline CirclePoint<Real> circlePoint(Real turns) {
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;
    const Real half = turns < 0.0f ? Real{} - 0.5f : Real{} + 0.5f;
    const Int quarters = toInt(4.0f * turns + half);
    const Real x = 6.28318531f * (turns - 0.25f * toFloat(quarters));
    const Real x2 = x * x;
    const Real sine = x - x * x2 * (1.0f / 6 - x2 * (1.0f / 120 - x2 * (1.0f / 5040 - x2 * (1.0f / 362880))));
    const Real cosine =
        1.0f - x2 * (0.5f - x2 * (1.0f / 24 - x2 * (1.0f / 720 - x2 * (1.0f / 40320 - x2 / 3628800.0f))));
    const Mask odd = (quarters & 1) != 0;
    const Real across = odd ? sine : cosine, up = odd ? cosine : sine;
    return {((quarters + 1) & 2) != 0 ? -across : across, (quarters & 2) != 0 ? -up : up};
}

/// Returns the angle, in [-1/2, 1/2], at which the point (x, y) is seen from (0, 0); 0 for the origin itself. Errors
/// are below 5e-8. Uses the series of the arc tangent up to a sixteenth of a turn.
template <class Real>
PDR_HD inline Real turnsTo(Real x, Real y) {
    using Mask = typename SimdTraits<Real>::Mask;
    constexpr float kTangent = 0.414213562f;  // tangent of a sixteenth of a turn
    const Real ax = max(x, -x), ay = max(y, -y);
    const Real far = max(ax, ay), ratio = far > 0.0f ? min(ax, ay) / far : Real{};
    const Mask steep = ratio > kTangent;
    const Real t = steep ? (ratio - 1.0f) / (ratio + 1.0f) : ratio;
    const Real t2 = t * t;
    Real series{};
    for (int n = 17; n > 1; n -= 2)
        series = t2 * (1.0f / float(n) - series);
    const Real within = (t - t * series) * 0.159154943f;
    const Real octant = steep ? 0.125f + within : within;
    const Real quadrant = ay > ax ? 0.25f - octant : octant;
    const Real upper = x < 0.0f ? 0.5f - quadrant : quadrant;
    return y < 0.0f ? -upper : upper;
}

}  // namespace pdr
