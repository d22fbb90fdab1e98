#pragma once
/// The whole transport on one page: single scattering with shadows, by Monte Carlo, without bias.

#include "render/kernel/camera_ray.h"
#include "render/kernel/event.h"
#include "render/kernel/lights.h"
#include "render/kernel/tracking.h"

namespace pdr {

/// The share of light that comes through from `towards` (unit, local) over `distance` mm to `position` (index space).
PDR_HD inline float visibility(const FlatScene& scene, vec3 position, vec3 towards, float distance,
                               RandomStream random) {
    return sampleTransmittance(scene, {position, scene.volume.indexFromLocal * towards, distance}, random);
}

/// Light that reaches `event` straight from a light and is scattered back along the path. One light a path.
template <std::uint32_t F>
PDR_HD inline vec3 directLight(const FlatScene& scene, const Event& event, const Random& random) {
    const int bounce = 0;
    RandomStream choice = random.stream(bounce, BounceDimension::light);
    const RandomStream shadow = random.stream(bounce, BounceDimension::shadow);
    const float u = choice.pair().x;
    if (has(F, kEnvironment) && u < scene.environmentProbability) {
        const Scattered scattered = scatterSample<F>(scene, event, random.stream(bounce, BounceDimension::direction));
        if (scattered.weight == vec3(0))
            return vec3(0);
        return scattered.weight * scene.environment *
               (visibility(scene, event.position, scattered.towards, kFarAway, shadow) / scene.environmentProbability);
    }
    if (scene.lightCount == 0)
        return vec3(0);
    const FlatLight& light = pickLight(scene, u - scene.environmentProbability);
    const vec3 from = has(F, kPlacedLights) ? localPosition(scene.volume, event.position) : vec3(0);
    const LightSample sample = sampleLight<F>(light, from, has(F, kPlacedLights) ? choice.pair() : vec2(0));
    const vec3 scattered = scatterEval<F>(scene, event, sample.towards) * sample.radiance;
    if (scattered == vec3(0))
        return vec3(0);
    return scattered *
           (visibility(scene, event.position, sample.towards, sample.distance, shadow) / light.probability);
}

/// One sample of the radiance [linear Rec. 709] that the camera sees through `pixel` (x, y). `depths`: see FlatViewBounds.
template <std::uint32_t F>
PDR_HD inline vec3 tracePath(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths) {
    const Random random(scene.seed, std::uint32_t(pixel.y * scene.camera.film.x + pixel.x), sample);
    const vec2 filter = random.stream(Dimension::filter).pair();
    const CameraRay camera = cameraRay(scene, vec2(pixel) + filter, depths);

    const float t = sampleCollision(scene, camera.ray, 0, random.stream(0, BounceDimension::flight));
    if (t < 0)
        return scene.environment * scene.environmentVisible;
    const Event event = eventAt<F>(scene, camera.ray.origin + camera.ray.direction * t, camera.direction,
                                   random.stream(0, BounceDimension::event));
    return directLight<F>(scene, event, random);
}

}  // namespace pdr
