#pragma once
/// Direct light at an event: one light path for each event, chosen among all lights.

#include "render/kernel/clip.h"
#include "render/kernel/sampler.h"
#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/transport/environment.h"
#include "render/kernel/transport/event.h"
#include "render/kernel/transport/lights.h"
#include "render/kernel/transport/many_lights.h"
#include "render/kernel/transport/mis.h"
#include "render/kernel/transport/ray_origin.h"

namespace pdr {

/// A path of light from a light to an event. Where nothing is in between, `radiance` arrives in the camera.
struct LightPath {
    Ray ray;        ///< ray from the event to the light
    vec3 radiance;  ///< linear Rec. 709; 0: nothing to trace
};

PDR_HD inline bool isDark(const LightPath& light) {
    return light.radiance == vec3(0);
}

/// One of several light paths, chosen in proportion to the unshadowed contribution of each and weighted so that it
/// stands for the sum of all on average (resampled importance sampling, Talbot et al. 2005).
struct LightReservoir {
    LightPath chosen{{vec3(0), vec3(0), 0}, vec3(0)};
    float weight = 0, total = 0;
    float u;  ///< the random number that chooses, rescaled: uniform whatever was chosen so far

    PDR_HD explicit LightReservoir(float number) : u(number) {}

    PDR_HD void offer(const LightPath& path) {
        const float strength = std::fabs(path.radiance.x + path.radiance.y + path.radiance.z);
        if (strength == 0)
            return;
        total += strength;
        if (strength == total || !(u * total >= strength)) {  // NaN is chosen, so that it is counted
            chosen = path;
            weight = strength;
            u *= total / strength;
        } else {
            u = (u * total - strength) / (total - strength);
        }
    }
    PDR_HD LightPath path() const {
        LightPath result = chosen;
        if (total != weight)
            result.radiance *= total / weight;
        return result;
    }
};

/// Calls visit(light, hit) for each light that a ray meets. `place`: the ray's origin; `direction`: unit; both local.
template <std::uint32_t F, class Visit>
PDR_HD inline void forLightsMet(const FlatScene& scene, vec3 place, vec3 direction, Visit&& visit) {
    if (!has(F, kPlacedLights))
        return;
    forLightsOnRay(scene, place, direction, [&](const FlatLight& light) {
        const LightHit hit = intersectLight(light, place - light.position, direction);
        if (hit.met && hit.distance > 0)
            visit(light, hit);
    });
}

/// Returns whether a path that continues from its event number `bounce` collects the light that it meets on its next
/// segment (lightOnSegment). The last event of a path has no next segment and samples a direction for itself.
PDR_HD inline bool continuationFindsLight(const FlatScene& scene, int bounce) {
    return scene.lightAlongPath && bounce + 1 < scene.maxBounces;
}

/// Returns a path of light that reaches the event directly from a light and is scattered back along the camera path.
/// Every light is sampled, or some of very many (many_lights.h). Where it pays, light is also sampled along a direction
/// that the event scatters to: here, or by the path itself where it continues. Light that both techniques can find is
/// weighted by multiple importance sampling.
template <std::uint32_t F>
PDR_HD inline LightPath directLight(const FlatScene& scene, const Event& event, const Sampler& sampler, int bounce) {
    const bool bothWays = has(F, kPlacedLights | kEnvironment) && scene.sampleDirections;
    const vec3 origin = rayOrigin<F>(scene, event);
    const vec3 place = has(F, kPlacedLights) ? localPosition(scene.volume, origin) : vec3(0);
    LightReservoir choice(sampler.number(bounce, BounceDimension::choice));
    const auto offer = [&](vec3 wi, float distance, vec3 radiance) {
        const float crossing = scene.unshadowed ? 1.0f : edgeTransmittance<F>(scene, event, wi);
        choice.offer({{origin, scene.volume.indexFromLocal * wi, distance}, radiance * crossing});
    };
    const auto offerSample = [&](const LightSample& light, float weight = 1) {
        const float other = bothWays && light.pdf > 0 ? scatterPdf<F>(scene, event, light.wi) : 0;
        offer(light.wi, light.distance,
              scatterEval<F>(scene, event, light.wi) * light.radiance * (weight * powerHeuristic(light.pdf, other)));
    };

    // All lights share one random position, since only one of them is chosen.
    const vec2 onLight = has(F, kPlacedLights) ? sampler.pair(bounce, BounceDimension::light) : vec2(0);
    forLightsLookedAt(scene, sampler, bounce, [&](const FlatLight& light, float weight) {
        offerSample(sampleLight<F>(light, place, onLight), weight);
    });
    // Sample the environment image.
    if (has(F, kEnvironment) && scene.environment.texels != nullptr)
        offerSample(sampleEnvironment(scene.environment, sampler.pair(bounce, BounceDimension::environment),
                                      sampler.stream(bounce, BounceDimension::environment).pair()));
    // Sample a scattered direction and offer the light that it meets.
    if (bothWays && !continuationFindsLight(scene, bounce)) {
        const Scattered along = scatterSample<F>(scene, event, sampler.triple(bounce, BounceDimension::direction));
        const float density = scatterPdf<F>(scene, event, along.wi);
        forLightsMet<F>(scene, place, along.wi, [&](const FlatLight& light, const LightHit& hit) {
            offer(along.wi, hit.distance, along.weight * light.radiance * powerHeuristic(density, hit.pdf));
        });
        if constexpr (has(F, kEnvironment))
            offer(along.wi, kFarAway,
                  along.weight * environmentRadiance(scene.environment, along.wi) *
                      powerHeuristic(density, environmentPdf(scene.environment, along.wi)));
    }

    // Take the chosen light path, and shorten it where clipped tissue casts no shadow.
    LightPath path = choice.path();
    if (scene.clip.count > 0 && !scene.clip.shadows)
        path.ray.length = cutLength(scene.clip, path.ray.origin, path.ray.direction, path.ray.length);
    if (scene.unshadowed)
        path.ray.length = 0;
    return path;
}

/// Returns the light that a path meets on a segment that was sampled with `pdf` and ends at an event after `collision`
/// mm (negative: it leaves the volume): the radiance of the lights before that event, and of the environment if the
/// segment leaves. It is weighted against directLight() at the event before, the other technique that finds it.
template <std::uint32_t F>
PDR_HD inline vec3 lightOnSegment(const FlatScene& scene, const PathSegment& segment, float pdf, float collision) {
    vec3 radiance(0);
    const vec3 place = has(F, kPlacedLights) ? localPosition(scene.volume, segment.ray.origin) : vec3(0);
    forLightsMet<F>(scene, place, segment.direction, [&](const FlatLight& light, const LightHit& hit) {
        if (collision < 0 || hit.distance < collision)
            radiance += light.radiance * powerHeuristic(pdf, hit.pdf);
    });
    if (has(F, kEnvironment) && collision < 0)
        radiance += environmentRadiance(scene.environment, segment.direction) *
                    powerHeuristic(pdf, environmentPdf(scene.environment, segment.direction));
    return radiance;
}

}  // namespace pdr
