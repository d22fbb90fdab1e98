#pragma once
/// Light that reaches an event straight from a light: one light path for each event, chosen among all lights.

#include "render/kernel/event.h"
#include "render/kernel/lights.h"
#include "render/kernel/ray.h"

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
struct LightChoice {
    LightPath chosen{{vec3(0), vec3(0), 0}, vec3(0)};
    float weight = 0, total = 0;

    PDR_HD void offer(const LightPath& path, float u) {
        const float strength = path.radiance.x + path.radiance.y + path.radiance.z;
        total += strength;
        if (u * total < strength) {
            chosen = path;
            weight = strength;
        }
    }
    PDR_HD LightPath path() const {
        LightPath result = chosen;
        if (total != 0)  // a light that is not a number stays one, to be counted
            result.radiance *= total / weight;
        return result;
    }
};

/// Light that reaches the event straight from one of the lights and is scattered back along the path.
template <std::uint32_t F>
PDR_HD inline LightPath directLight(const FlatScene& scene, const Event& event, const Random& random, int bounce) {
    RandomStream numbers = random.stream(bounce, BounceDimension::light);
    LightChoice choice;
    const auto offer = [&](vec3 towards, float distance, vec3 radiance) {
        choice.offer({{event.position, scene.volume.indexFromLocal * towards, distance}, radiance}, numbers.pair().x);
    };
    const vec3 from = has(F, kPlacedLights) ? localPosition(scene.volume, event.position) : vec3(0);
    for (int i = 0; i < scene.lightCount; ++i) {
        const LightSample sample =
            sampleLight<F>(scene.lights[i], from, has(F, kPlacedLights) ? numbers.pair() : vec2(0));
        offer(sample.towards, sample.distance, scatterEval<F>(scene, event, sample.towards) * sample.radiance);
    }
    if constexpr (has(F, kEnvironment)) {
        const Scattered scattered = scatterSample<F>(scene, event, random.stream(bounce, BounceDimension::direction));
        offer(scattered.towards, kFarAway, scattered.weight * scene.environment);
    }
    return choice.path();
}

}  // namespace pdr
