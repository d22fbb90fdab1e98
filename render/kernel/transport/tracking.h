#pragma once
/// Unbiased tracking through the medium: delta tracking for the next event, ratio tracking for what light survives.
/// Each is a estimator of what a tentative collision does to a ray; the flight between them is the same.

#include <cmath>

#include "render/kernel/transport/majorant_traversal.h"

namespace pdr {

/// Tentative collisions and cells that one ray may take. Reached only where tissue of millions of free paths per voxel
/// lies beside none in the same voxel; what became of the ray is then no number, so that the picture's sample is left
/// out and counted (Fault::notANumber). Tissue that needs no close look has a few steps per cell.
inline constexpr int kMostSteps = 1 << 24;

/// Delta tracking: a tentative collision is real with probability extinction / majorant, and then ends the ray.
/// Result: the distance of the collision [mm], -1 where the ray leaves the volume, or NaN: see kMostSteps.
template <class Real>
struct DeltaTracking {
    using Mask = typename SimdTraits<Real>::Mask;
    Real result = Real{} - 1.0f;

    PDR_HD Mask onCollision(Real t, const TentativeCollision<Real>& collision) {
        const Mask real = collision.happened & (collision.u * collision.majorant < collision.extinction);
        result = real ? t : result;
        return real;
    }
};

/// Ratio tracking (Novak et al. 2014): each tentative collision leaves 1 - extinction / majorant, with exact Russian
/// roulette when little is left. Result: an unbiased estimate of the transmittance along the ray.
template <class Real>
struct RatioTracking {
    using Mask = typename SimdTraits<Real>::Mask;
    static constexpr float kRouletteBelow = 0.1f;
    Real result = Real{} + 1.0f;

    PDR_HD Mask onCollision(Real, const TentativeCollision<Real>& collision) {
        if (!any(collision.happened))
            return Mask{};
        const Real left = result * (1.0f - collision.extinction / collision.majorant);
        result = collision.happened ? left : result;
        const Mask little = collision.happened & (result < kRouletteBelow);
        const Mask lost = little & (collision.u * kRouletteBelow >= result);
        result = little ? Real{} + kRouletteBelow : result;
        result = lost ? Real{} : result;
        return lost;
    }
};

/// One ray to its end. `overMajorant` is set where an extinction above its bound is met.
template <template <class> class Estimator, bool Dense>
PDR_HD inline float track(const FlatScene& scene, const Ray& ray, const RandomStream& random, bool& overMajorant) {
    MajorantTraversal<float, Dense> flight;
    flight.start(scene.majorants, {ray.origin.x, ray.origin.y, ray.origin.z},
                 {ray.direction.x, ray.direction.y, ray.direction.z}, ray.length, random);
    Estimator<float> estimator;
    for (int steps = 0; flight.isActive(); ++steps) {
        if (Dense && steps == kMostSteps)
            return NAN;
        const TentativeCollision<float> collision = flight.step(scene);
        overMajorant = overMajorant || (collision.happened && collision.extinction > collision.majorant);
        if (estimator.onCollision(flight.t, collision))
            break;
    }
    return estimator.result;
}

template <template <class> class Estimator>
PDR_HD inline float track(const FlatScene& scene, const Ray& ray, const RandomStream& random, bool& overMajorant) {
    return scene.majorants.dense ? track<Estimator, true>(scene, ray, random, overMajorant)
                                 : track<Estimator, false>(scene, ray, random, overMajorant);
}

template <template <class> class Estimator>
PDR_HD inline float track(const FlatScene& scene, const Ray& ray, const RandomStream& random) {
    bool overMajorant = false;
    return track<Estimator>(scene, ray, random, overMajorant);
}

}  // namespace pdr
