#pragma once
/// Unbiased tracking through the medium: delta tracking for the next event, ratio tracking for what light survives.

#include "render/kernel/majorant_walk.h"
#include "render/kernel/medium.h"
#include "render/kernel/random.h"

namespace pdr {

/// Distance [mm] to the first real collision on the ray after `begin`, or a negative number when it leaves the volume.
/// Woodcock et al. 1965 over local bounds; what is left of the optical depth is carried from cell to cell.
PDR_HD inline float sampleCollision(const FlatScene& scene, const Ray& ray, float begin, RandomStream random) {
    vec2 u = random.pair();
    float depth = -std::log(u.x);
    float collision = -1;
    walkMajorants(scene.majorants, ray, begin, [&](float t, float end, float majorant) {
        for (;;) {
            const float flight = depth / majorant;
            if (!(t + flight < end)) {
                depth -= (end - t) * majorant;
                return true;
            }
            t += flight;
            if (u.y * majorant < extinction(scene, ray.origin + ray.direction * t)) {
                collision = t;
                return false;
            }
            u = random.pair();
            depth = -std::log(u.x);
        }
    });
    return collision;
}

inline constexpr float kRouletteBelow = 0.1f;  ///< transmittance under which a shadow ray is continued by chance only

/// An unbiased estimate of the transmittance from the ray's origin to its end: the product of 1 - extinction / majorant
/// over tentative collisions (ratio tracking, Novak et al. 2014), with exact Russian roulette when little is left.
PDR_HD inline float sampleTransmittance(const FlatScene& scene, const Ray& ray, RandomStream random) {
    vec2 u = random.pair();
    float depth = -std::log(u.x);
    float transmittance = 1;
    walkMajorants(scene.majorants, ray, 0, [&](float t, float end, float majorant) {
        for (;;) {
            const float flight = depth / majorant;
            if (!(t + flight < end)) {
                depth -= (end - t) * majorant;
                return true;
            }
            t += flight;
            transmittance *= 1 - extinction(scene, ray.origin + ray.direction * t) / majorant;
            if (transmittance < kRouletteBelow) {
                if (u.y * kRouletteBelow >= transmittance) {
                    transmittance = 0;
                    return false;
                }
                transmittance = kRouletteBelow;
            }
            u = random.pair();
            depth = -std::log(u.x);
        }
    });
    return transmittance;
}

}  // namespace pdr
