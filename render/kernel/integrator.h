#pragma once
/// The whole transport on one page: single scattering with shadows, by Monte Carlo, without bias.
///   cameraStart -> track<DeltaTracking> -> arrival -> track<RatioTracking> -> radiance
/// A path is a value that goes through these steps; a GPU takes one at a time, the CPU many in step.

#include "render/kernel/camera_ray.h"
#include "render/kernel/event.h"
#include "render/kernel/lights.h"

namespace pdr {

/// One sample of one pixel, before its first event.
struct Path {
    Random random;
    CameraRay camera;
};

/// Light on its way from a light to an event: `radiance` arrives in the camera where nothing is in between.
struct LightPath {
    Ray ray;        ///< from the event to the light
    vec3 radiance;  ///< linear Rec. 709; 0: nothing to trace
};

/// `depths`: where matter lies along the pixel's view; see FlatViewBounds.
PDR_HD inline Path cameraStart(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths) {
    const Random random(scene.seed, std::uint32_t(pixel.y * scene.camera.film.x + pixel.x), sample);
    const vec2 filter = random.stream(Dimension::filter).pair();
    return {random, cameraRay(scene, vec2(pixel) + filter, depths)};
}

PDR_HD inline vec3 background(const FlatScene& scene) {
    return scene.environment * scene.environmentVisible;
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

/// Light that reaches the event straight from one of the lights and is scattered into the camera.
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

/// What happens at the end of the camera ray: light that starts there, and light that is scattered there.
struct Arrival {
    vec3 emitted;  ///< radiance, linear Rec. 709
    LightPath scattered;
};

/// `collision` is the distance of the first event [mm]. An event is met with the density of what extinction takes from
/// the ray, so emission, which is counted per optical depth, comes in as it is.
template <std::uint32_t F>
PDR_HD inline Arrival arrival(const FlatScene& scene, const Path& path, float collision) {
    const int bounce = 0;
    const Event event = eventAt<F>(scene, path.camera.ray.origin + path.camera.ray.direction * collision,
                                   path.camera.direction, path.random.stream(bounce, BounceDimension::event));
    return {has(F, kEmission) ? event.material.emission : vec3(0), directLight<F>(scene, event, path.random, bounce)};
}

PDR_HD inline bool isDark(const LightPath& light) {
    return light.radiance == vec3(0);
}

}  // namespace pdr
