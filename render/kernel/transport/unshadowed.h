#pragma once
/// A place as it would look if nothing stood in the light's way, without a random number: a surface and what scatters
/// as fog each by its probability, each light by its middle. No light is scattered twice, surroundings are even. What
/// light really does is in integrator.h; this is what a guide (denoise/guided.h) shows.

#include "render/kernel/transport/event.h"
#include "render/kernel/transport/lights.h"

namespace pdr {

struct UnshadowedPlace {
    vec3 radiance{0.0f};
    vec3 normal{0.0f};  ///< local, unit, on the side that it is seen from; 0: the tissue is even there
};

/// Of the light that arrives, what counts as coming from all sides: no tissue that many paths light up is black.
inline constexpr float kFromAllSides = 0.02f;

/// `position`: index space. `wo`: unit, local, to where it is seen from.
PDR_HD inline UnshadowedPlace unshadowedAt(const FlatScene& scene, vec3 position, vec3 wo) {
    const float hu = hounsfield(scene.volume, position);
    const Material material = materialAt(scene.transferFunction, hu);
    const vec3 gradient = seenGradient(scene, position, hu);
    const float steepness = glm::length(gradient);
    UnshadowedPlace seen{material.emission};
    float surface = 0;
    if (steepness > 0) {
        seen.normal = gradient * ((glm::dot(gradient, wo) < 0 ? -1 : 1) / steepness);
        surface = surfaceProbability(scene, opacity(scene.transferFunction, hu), steepness);
    }
    vec3 arriving = 0.5f * (scene.environment.zenith + scene.environment.nadir);
    const vec3 place = localPosition(scene.volume, position);
    for (int i = 0; i < scene.lightCount; ++i) {
        const LightSample light = sampleLight<kPlacedLights>(scene.lights[i], place, vec2(0.5f));
        const vec3 asFog = material.albedo * phaseEval(scene.phaseG, wo, light.wi);
        const vec3 asSurface = surface > 0 ? surfaceEval(material, seen.normal, wo, light.wi) : vec3(0);
        seen.radiance += glm::mix(asFog, asSurface, surface) * light.radiance;
        arriving += kFromAllSides * light.radiance;
    }
    seen.radiance += material.albedo * arriving;
    return seen;
}

}  // namespace pdr
