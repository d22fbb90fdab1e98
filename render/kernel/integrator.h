#pragma once
/// The whole transport on one page, by Monte Carlo, without bias.
///   cameraStart -> track<DeltaTracking> -> arrival -> track<RatioTracking>, and again while the path goes on
/// A path is a value that goes through these steps; a GPU's thread takes one at a time (takeLeg), the CPU many in step.
/// All light comes in by next-event estimation: a path that leaves the volume after an event brings nothing more.

#include "render/kernel/camera_ray.h"
#include "render/kernel/direct_light.h"
#include "render/kernel/event.h"
#include "render/kernel/tracking.h"

namespace pdr {

/// One sample of one pixel, on its way to its next event.
struct Path {
    Random random;
    Leg leg;
    vec3 throughput{1.0f};  ///< of radiance from the next event to the camera
};

/// `depths`: where matter lies along the pixel's view; see FlatViewBounds.
PDR_HD_INLINE Path cameraStart(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths) {
    const Random random(scene.seed, std::uint32_t(pixel.y * scene.camera.film.x + pixel.x), sample);
    const vec2 filter = random.stream(Dimension::filter).pair();
    const vec2 lens = scene.camera.focus > 0 ? onDisc(random.stream(Dimension::lens).pair()) : vec2(0);
    return {random, cameraLeg(scene, vec2(pixel) + filter, lens, depths)};
}

/// What the camera sees along a leg that meets no event.
PDR_HD inline vec3 background(const FlatScene& scene, const Leg& leg) {
    if (leg.light >= 0)
        return scene.lights[leg.light].radiance;
    return scene.environment.visible ? environmentRadiance(scene.environment, leg.direction) : vec3(0);
}

/// What a leg that meets no event brings: the background, or no number where its ray came to no end (kMostSteps).
PDR_HD inline vec3 missed(const FlatScene& scene, const Leg& leg, float collision) {
    return collision < 0 ? background(scene, leg) : vec3(collision);
}

/// The same without looking, where it looks the same everywhere.
PDR_HD inline vec3 plainBackground(const FlatScene& scene) {
    return scene.environment.visible ? scene.environment.zenith : vec3(0);
}

/// Exact Russian roulette: little throughput goes on rarely and then counts for more, so that its mean stays.
PDR_HD inline bool survives(vec3& throughput, float u) {
    constexpr float kRouletteBelow = 0.25f;
    const float most = glm::max(glm::max(throughput.x, throughput.y), throughput.z);
    if (!(most < kRouletteBelow))  // what is not a number goes on, to be met and counted
        return true;
    if (u * kRouletteBelow >= most)
        return false;
    throughput *= kRouletteBelow / most;
    return true;
}

/// The path's next leg, away from `event`; false where it ends.
template <std::uint32_t F>
PDR_HD inline bool goesOn(const FlatScene& scene, Path& path, const Event& event, int bounce) {
    const Scattered scattered = scatterSample<F>(scene, event, path.random.stream(bounce, BounceDimension::onward));
    path.throughput *= scattered.weight;
    const vec3 direction = scene.volume.indexFromLocal * scattered.towards;
    path.leg = {{event.position, direction, cutLength(scene.clip, event.position, direction, kFarAway)},
                scattered.towards};
    return survives(path.throughput, path.random.stream(bounce, BounceDimension::survival).pair().x);
}

/// What happens at the end of a leg: light that starts there, light that is scattered there, and whether the path,
/// now on its next leg, goes on.
struct Arrival {
    vec3 emitted;  ///< radiance, linear Rec. 709
    LightPath scattered;
    bool goesOn;
    bool cut;  ///< it would have gone on, but may not
};

/// `collision` is the distance of the event [mm]. An event is met with the density of what extinction takes from the
/// ray, so emission, which is counted per optical depth, comes in as it is.
template <std::uint32_t F>
PDR_HD inline Arrival arrival(const FlatScene& scene, Path& path, float collision, int bounce) {
    const Event event = eventAt<F>(scene, path.leg.ray.origin + path.leg.ray.direction * collision, path.leg.direction,
                                   path.random.stream(bounce, BounceDimension::event));
    Arrival met{has(F, kEmission) ? event.material.emission : vec3(0),
                directLight<F>(scene, event, path.random, bounce), false, false};
    if constexpr (has(F, kBounces)) {
        met.emitted *= path.throughput;
        met.scattered.radiance *= path.throughput;
        const bool alive = scene.maxBounces > 1 && goesOn<F>(scene, path, event, bounce);
        met.cut = alive && bounce + 1 >= scene.maxBounces;
        met.goesOn = alive && !met.cut;
    }
    return met;
}

/// What a path brought.
struct Sampled {
    vec3 radiance{0.0f};        ///< linear Rec. 709
    bool overMajorant = false;  ///< see Fault
    bool cut = false;           ///< see Fault::cutPath
    bool tissue = false;        ///< it met some
};

/// For tracePath(): nobody watches.
struct Unwatched {
    PDR_HD void leg(const Path&, int, float) {}
    PDR_HD void light(const Arrival&, float) {}
};

/// One leg of a path, and what is met at its end; false where the path ends. `bounce`: legs before it.
template <std::uint32_t F, class Watch>
PDR_HD_INLINE bool takeLeg(const FlatScene& scene, Path& path, int bounce, Sampled& result, Watch&& watch) {
    const float collision = track<DeltaTracking>(
        scene, path.leg.ray, path.random.stream(bounce, BounceDimension::flight), result.overMajorant);
    watch.leg(path, bounce, collision);
    if (!(collision >= 0)) {
        if (bounce == 0 || collision != collision)
            result.radiance = missed(scene, path.leg, collision);
        return false;
    }
    result.tissue = true;
    const Arrival met = arrival<F>(scene, path, collision, bounce);
    result.radiance += met.emitted;
    float transmittance = 0;
    if (!isDark(met.scattered)) {
        transmittance = track<RatioTracking>(scene, met.scattered.ray,
                                             path.random.stream(bounce, BounceDimension::shadow), result.overMajorant);
        if (transmittance != 0)  // in full shadow not even infinite light counts
            result.radiance += met.scattered.radiance * transmittance;
    }
    watch.light(met, transmittance);
    result.cut = met.cut;
    return met.goesOn;
}

/// One sample of the radiance that the camera sees through `pixel` (x, y). `watch` is told each leg with the distance
/// of its event (-1: none), and then what was met there with the transmittance of the way to the light.
template <std::uint32_t F, class Watch>
PDR_HD inline Sampled tracePath(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths, Watch&& watch) {
    Path path = cameraStart(scene, pixel, sample, depths);
    Sampled result;
    int bounce = 0;
    while (takeLeg<F>(scene, path, bounce, result, watch))
        ++bounce;
    return result;
}

}  // namespace pdr
