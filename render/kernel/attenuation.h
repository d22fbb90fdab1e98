#pragma once
/// Attenuation of light by an optical depth. Everything is in single precision with the same arithmetic on every
/// device, so that devices agree bit by bit. Relative errors are below 3e-7 (absorbedBeforeMiddle: 1e-6).

#include "render/base/lanes.h"

namespace pdr {

template <class Real>
struct Attenuation {
    Real left;   ///< exp(-depth); 0 above kOpaqueDepth
    Real taken;  ///< 1 - exp(-depth), without cancellation
};

/// Depth from which on all light counts as absorbed: exp(-87) is the last whole power that float holds in full.
inline constexpr float kOpaqueDepth = 87;

/// Returns the attenuation over an optical depth >= 0: exp(-depth) = 2^-n exp(r), |r| <= ln(2) / 2.
template <class Real>
PDR_HD_INLINE Attenuation<Real> attenuation(Real depth) {
    using Int = typename SimdTraits<Real>::Int;
    const Real within = min(depth, Real{} + kOpaqueDepth);
    const Int n = toInt(within * 1.44269504f + 0.5f);
    const Real whole = toFloat(n);
    const Real r = (whole * 0.693359375f - within) + whole * -2.12194440e-4f;
    const Real powers =
        r *
        (1.0f + r * (1.0f / 2 + r * (1.0f / 6 + r * (1.0f / 24 + r * (1.0f / 120 + r * (1.0f / 720 + r / 5040.0f))))));
    const Real scale = floatOf(Int((127 - n) << 23));
    const Real left = scale + scale * powers;
    const Real taken = (1.0f - scale) - scale * powers;
    return {depth > kOpaqueDepth ? Real{} : left, depth > kOpaqueDepth ? Real{} + 1.0f : taken};
}

/// Returns the optical depth that absorbs the fraction `taken`, in [0, 1 - 2^-24], of the light: -ln(1 - taken),
/// without cancellation.
template <class Real>
PDR_HD_INLINE Real depthThatTakes(Real taken) {
    const Real left = 1.0f - taken;
    // The ratio corrects the rounding of 1 - taken (Kahan).
    return left == 1.0f ? taken : negativeLog(left) * (taken / (1.0f - left));
}

/// Returns how far in front of the middle of a layer light is absorbed on average, as a fraction of the layer's optical
/// depth: 1/2 - integral of w D exp(-D w) dw over [0, 1] / (1 - exp(-D)) = L(D / 2) / 2 with Langevin's function L(a) =
/// coth(a) - 1 / a. Below a = 1 it uses the continued fraction of L, cut after four levels.
template <class Real>
PDR_HD_INLINE Real absorbedBeforeMiddle(Real depth, const Attenuation<Real>& behind) {
    const Real a = 0.5f * depth, a2 = a * a;
    const Real thin = a * (315.0f + 14.0f * a2) / (945.0f + a2 * (105.0f + a2));
    const Real thick = (1.0f + behind.left) / behind.taken - 1.0f / a;
    return 0.5f * (depth > 2.0f ? thick : thin);
}

}  // namespace pdr
