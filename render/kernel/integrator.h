#pragma once
/// The whole transport on one page: single scattering with shadows, by Monte Carlo, without bias.
///   cameraStart -> track<DeltaTracking> -> scatteredLight -> track<RatioTracking> -> radiance
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

/// Light that reaches the event straight from one light, picked by chance, and is scattered into the camera.
template <std::uint32_t F>
PDR_HD inline LightPath directLight(const FlatScene& scene, const Event& event, const Random& random, int bounce) {
    RandomStream choice = random.stream(bounce, BounceDimension::light);
    const float u = choice.pair().x;
    const auto towards = [&](vec3 direction, float distance, vec3 radiance) {
        return LightPath{{event.position, scene.volume.indexFromLocal * direction, distance}, radiance};
    };
    if (has(F, kEnvironment) && (u < scene.environmentProbability || scene.lightCount == 0)) {
        const Scattered scattered = scatterSample<F>(scene, event, random.stream(bounce, BounceDimension::direction));
        return towards(scattered.towards, kFarAway,
                       scattered.weight * scene.environment / scene.environmentProbability);
    }
    if (scene.lightCount == 0)
        return towards(vec3(0), 0, vec3(0));
    const FlatLight& light = pickLight(scene, u - scene.environmentProbability);
    const vec3 from = has(F, kPlacedLights) ? localPosition(scene.volume, event.position) : vec3(0);
    const LightSample sample = sampleLight<F>(light, from, has(F, kPlacedLights) ? choice.pair() : vec2(0));
    return towards(sample.towards, sample.distance,
                   scatterEval<F>(scene, event, sample.towards) * sample.radiance / light.probability);
}

/// What happens at the end of the camera ray: `collision` is its distance [mm].
template <std::uint32_t F>
PDR_HD inline LightPath scatteredLight(const FlatScene& scene, const Path& path, float collision) {
    const int bounce = 0;
    const Event event = eventAt<F>(scene, path.camera.ray.origin + path.camera.ray.direction * collision,
                                   path.camera.direction, path.random.stream(bounce, BounceDimension::event));
    return directLight<F>(scene, event, path.random, bounce);
}

PDR_HD inline bool isDark(const LightPath& light) {
    return light.radiance == vec3(0);
}

}  // namespace pdr
