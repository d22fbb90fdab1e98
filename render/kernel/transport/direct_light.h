#pragma once
/// Light that reaches an event straight from a light: one light path for each event, chosen among all lights.

#include "render/kernel/clip.h"
#include "render/kernel/transport/environment.h"
#include "render/kernel/transport/event.h"
#include "render/kernel/transport/lights.h"
#include "render/kernel/transport/mis.h"

namespace pdr {

/// Light on its way from a light to an event: `radiance` arrives in the camera where nothing is in between.
struct LightPath {
    Ray ray;        ///< from the event to the light
    vec3 radiance;  ///< linear Rec. 709; 0: nothing to trace
};

PDR_HD inline bool isDark(const LightPath& light) {
    return light.radiance == vec3(0);
}

/// Of several light paths one, picked in proportion to what each would bring if nothing stood in its way, and weighted
/// so that the sum of all is what it stands for on average (resampled importance sampling, Talbot et al. 2005).
struct LightReservoir {
    LightPath chosen{{vec3(0), vec3(0), 0}, vec3(0)};
    float weight = 0, total = 0;

    PDR_HD void offer(const LightPath& path, float u) {
        const float strength = std::fabs(path.radiance.x + path.radiance.y + path.radiance.z);
        total += strength;
        if (strength == total || !(u * total >= strength)) {  // what is no number is chosen, to be counted
            chosen = path;
            weight = strength;
        }
    }
    PDR_HD LightPath path() const {
        LightPath result = chosen;
        if (total != weight)
            result.radiance *= total / weight;
        return result;
    }
};

/// Light that reaches the event straight from one of the lights and is scattered back along the path. Every light is
/// sampled; where it pays, light is also looked for in one direction that the event scatters to. What both ways can
/// find counts for each by its fraction.
template <std::uint32_t F>
PDR_HD inline LightPath directLight(const FlatScene& scene, const Event& event, const Random& random, int bounce) {
    RandomStream onLight = random.stream(bounce, BounceDimension::light);
    RandomStream chances = random.stream(bounce, BounceDimension::choice);
    const bool alongScatter = has(F, kPlacedLights | kEnvironment) && scene.sampleDirections;
    const vec3 place = has(F, kPlacedLights) ? localPosition(scene.volume, event.position) : vec3(0);
    LightReservoir choice;
    const auto offer = [&](vec3 wi, float distance, vec3 radiance) {
        choice.offer({{event.position, scene.volume.indexFromLocal * wi, distance}, radiance}, chances.pair().x);
    };
    const auto offerSample = [&](const LightSample& light) {
        const float other = alongScatter && light.pdf > 0 ? scatterPdf<F>(scene, event, light.wi) : 0;
        offer(light.wi, light.distance,
              scatterEval<F>(scene, event, light.wi) * light.radiance * powerHeuristic(light.pdf, other));
    };

    for (int i = 0; i < scene.lightCount; ++i)
        offerSample(sampleLight<F>(scene.lights[i], place, has(F, kPlacedLights) ? onLight.pair() : vec2(0)));
    if (has(F, kEnvironment) && scene.environment.texels != nullptr) {
        RandomStream texel = random.stream(bounce, BounceDimension::environment);
        const vec2 choice = texel.pair();
        offerSample(sampleEnvironment(scene.environment, choice, texel.pair()));
    }
    if (alongScatter) {
        const Scattered along = scatterSample<F>(scene, event, random.stream(bounce, BounceDimension::direction));
        const float density = scatterPdf<F>(scene, event, along.wi);
        for (int i = 0; has(F, kPlacedLights) && i < scene.lightCount; ++i) {
            const LightHit hit = intersectLight(scene.lights[i], place - scene.lights[i].position, along.wi);
            if (hit.met && hit.distance > 0)
                offer(along.wi, hit.distance,
                      along.weight * scene.lights[i].radiance * powerHeuristic(density, hit.pdf));
        }
        if constexpr (has(F, kEnvironment))
            offer(along.wi, kFarAway,
                  along.weight * environmentRadiance(scene.environment, along.wi) *
                      powerHeuristic(density, environmentPdf(scene.environment, along.wi)));
    }

    LightPath path = choice.path();
    if (scene.clip.count > 0 && !scene.clip.shadows)
        path.ray.length = cutLength(scene.clip, path.ray.origin, path.ray.direction, path.ray.length);
    if (scene.unshadowed)
        path.ray.length = 0;
    return path;
}

}  // namespace pdr
