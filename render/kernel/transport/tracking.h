#pragma once
/// Unbiased tracking through the medium: delta tracking finds the next event, ratio tracking estimates the
/// transmittance. Each is an estimator that handles the tentative collisions of a ray; the traversal between them is
/// the same.

#include <cmath>

#include "render/kernel/transport/majorant_traversal.h"

namespace pdr {

/// Limit on the tentative collisions and cells of one ray. It is reached only where tissue of millions of free paths
/// per voxel lies beside transparent tissue in the same voxel. The result of the ray is then NaN, so that the sample of
/// the image is rejected and counted (Fault::notANumber). Tissue that needs no bounds of voxels takes a few steps per
/// cell.
inline constexpr int kMostSteps = 1 << 24;

/// Delta tracking: a tentative collision is real with probability extinction / majorant, and then ends the ray. The
/// result is the distance of the collision [mm], -1 if the ray leaves the volume, or NaN: see kMostSteps.
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
/// roulette when little is left. The result is an unbiased estimate of the transmittance along the ray.
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

/// Tracks one ray to its end. Sets `overMajorant` if an extinction above its bound is met.
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
