#pragma once
/// The radiance of a position without shadows and without random numbers, for guide images (denoise/guided.h). Surface
/// reflection and the phase function are weighted by their probabilities, and each light is represented by its centre.
/// Light is scattered once, and the environment is uniform. integrator.h has the unbiased transport.

#include "render/kernel/transport/event.h"
#include "render/kernel/transport/lights.h"
#include "render/kernel/transport/ray_origin.h"

namespace pdr {

struct UnshadowedPlace {
    vec3 radiance{0.0f};
    vec3 normal{0.0f};  ///< local, unit, on the side of wo; 0: the tissue has no gradient there
};

/// Fraction of the arriving light that counts as coming from all sides, so that tissue that is lit by multiple
/// scattering is not black.
inline constexpr float kFromAllSides = 0.02f;

/// Returns the unshadowed radiance at `position` (index space). `wo`: unit, local, towards the viewer.
PDR_HD inline UnshadowedPlace unshadowedAt(const FlatScene& scene, vec3 position, vec3 wo) {
    const float hu = hounsfield(scene.volume, position);
    float middle = 0.5f;
    const FlatTransferFunction curve = curveMet(scene, position, hu, middle);
    const Material material = materialAt(curve, hu);
    const vec3 gradient = surfaceGradient(scene, curve, position, hu);
    const float steepness = glm::length(gradient);
    UnshadowedPlace seen{material.emission};
    float surface = 0;
    if (steepness > 0) {
        seen.normal = gradient * ((glm::dot(gradient, wo) < 0 ? -1 : 1) / steepness);
        surface = surfaceProbability(curve, opacity(curve, hu), steepness);
    }
    vec3 arriving = 0.5f * (scene.environment.zenith + scene.environment.nadir);
    const vec3 place = localPosition(scene.volume, position);
    for (int i = 0; i < scene.lightCount; ++i) {
        const LightSample light = sampleLight<kPlacedLights>(scene.lights[i], place, vec2(0.5f));
        const vec3 asFog = material.albedo * phaseEval(scene.phaseG, wo, light.wi);
        vec3 asSurface = surface > 0 ? surfaceEval(material, seen.normal, wo, light.wi) : vec3(0);
        if (scene.raysStartOutside)
            asSurface *= edgeTransmittance(glm::dot(seen.normal, wo), glm::dot(seen.normal, light.wi));
        seen.radiance += glm::mix(asFog, asSurface, surface) * light.radiance;
        arriving += kFromAllSides * light.radiance;
    }
    seen.radiance += material.albedo * arriving;
    return seen;
}

}  // namespace pdr
