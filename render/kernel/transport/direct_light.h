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
template <class Real>
struct LightPathOf {
    RayOf<Real> ray;      ///< ray from the event to the light
    Vec3<Real> radiance;  ///< linear Rec. 709; 0: nothing to trace
};
using LightPath = LightPathOf<float>;

PDR_HD inline bool isDark(const LightPath& light) {
    return light.radiance == vec3(0);
}

/// One of several lights, chosen in proportion to the unshadowed contribution of each and weighted so that it stands
/// for the sum of all on average (resampled importance sampling, Talbot et al. 2005).
template <class Real>
struct LightReservoir {
    using Mask = typename SimdTraits<Real>::Mask;

    Vec3<Real> wi{};        ///< direction to the chosen light, unit, local
    Real distance{};        ///< mm
    Vec3<Real> radiance{};  ///< linear Rec. 709
    Real weight{}, total{};
    Real u;  ///< the random number that chooses, rescaled: uniform whatever was chosen so far

    PDR_HD explicit LightReservoir(Real number) : u(number) {}

    PDR_HD void offer(Mask mask, const Vec3<Real>& direction, Real away, const Vec3<Real>& light) {
        const Real strength = magnitude(light.x + light.y + light.z);
        const Mask offered = mask & (strength != 0.0f);
        if (!any(offered))
            return;
        const Real sum = total + strength;
        // NaN is chosen, so that it is counted.
        const Mask taken = offered & ((strength == sum) | !(u * sum >= strength)), left = offered & !taken;
        total = offered ? sum : total;
        if (any(left))
            u = left ? (u * sum - strength) / (sum - strength) : u;
        if (any(taken)) {
            u = taken ? u * (sum / strength) : u;
            wi = chosen(taken, direction, wi);
            distance = taken ? away : distance;
            radiance = chosen(taken, light, radiance);
            weight = taken ? strength : weight;
        }
    }
    /// Returns the radiance of the chosen light that stands for all.
    PDR_HD Vec3<Real> radianceOfAll() const {
        const Mask several = total != weight;
        return any(several) ? chosen(several, radiance * (total / weight), radiance) : radiance;
    }
};

/// Calls visit(light, hit) for each light that a ray meets. `place`: the ray's origin; `direction`: unit; both local.
template <std::uint32_t F, class Real, class Visit>
PDR_HD inline void forLightsMet(const FlatScene& scene, const Vec3<Real>& place, const Vec3<Real>& direction,
                                Visit&& visit) {
    if (!has(F, kPlacedLights))
        return;
    forLightsOnRay<Real>(scene, place, direction, [&](const FlatLight& light) {
        LightHitOf<Real> hit = intersectLight<Real>(light, place - light.position, direction);
        hit.met = hit.met & (hit.distance > 0.0f);
        if (any(hit.met))
            visit(light, hit);
    });
}

/// Returns whether a path that continues from its event number `bounce` collects the light that it meets on its next
/// segment (lightOnSegment). The last event of a path has no next segment and samples a direction for itself.
PDR_HD inline bool continuationFindsLight(const FlatScene& scene, int bounce) {
    return scene.lightAlongPath && bounce + 1 < scene.maxBounces;
}

/// Whether light is sampled along a direction that events scatter to, too: where it pays.
template <std::uint32_t F>
PDR_HD inline bool bothWays(const FlatScene& scene) {
    return has(F, kPlacedLights | kEnvironment) && scene.sampleDirections;
}

/// The random numbers for the light of an event, or of several in lanes.
template <class Real>
struct LightNumbersOf {
    Real choice;           ///< number that chooses the light
    Vec2<Real> onLight;    ///< all lights share one position, since only one of them is chosen
    Vec3<Real> direction;  ///< numbers for a direction that the event scatters to
    Real looksAlong;       ///< 1: light is sought along that direction, too
};
using LightNumbers = LightNumbersOf<float>;

template <std::uint32_t F>
PDR_HD inline LightNumbers lightNumbers(const FlatScene& scene, const Sampler& sampler, int bounce) {
    LightNumbers numbers{sampler.number(bounce, BounceDimension::choice), vec2(0), vec3(0), 0};
    if (has(F, kPlacedLights))
        numbers.onLight = sampler.pair(bounce, BounceDimension::light);
    if (bothWays<F>(scene) && !continuationFindsLight(scene, bounce)) {
        numbers.direction = sampler.triple(bounce, BounceDimension::direction);
        numbers.looksAlong = 1;
    }
    return numbers;
}

/// The search for the light of an event, or of several in lanes.
template <std::uint32_t F, class Real>
class LightSearch {
  public:
    using Mask = typename SimdTraits<Real>::Mask;

    PDR_HD LightSearch(const FlatScene& scene, const EventOf<Real>& event, const LightNumbersOf<Real>& numbers)
        : scene_(scene),
          event_(event),
          numbers_(numbers),
          origin_(rayOrigin<F>(scene, event)),
          choice_(numbers.choice) {
        if constexpr (has(F, kPlacedLights))
            place_ = localPosition(scene.volume, origin_);
    }

    PDR_HD void offerLight(const FlatLight& light, float weight) {
        offer(sampleLight<F, Real>(light, place_, numbers_.onLight), weight);
    }
    /// Offers a sample of a light, weighted against what offerScattered() would have found.
    PDR_HD void offer(const LightSampleOf<Real>& light, float weight) {
        Real other{};
        if (bothWays<F>(scene_)) {
            const Mask found = light.pdf > 0.0f;
            if (any(found))
                other = found ? scatterPdf<F>(scene_, event_, light.wi) : other;
        }
        offer(Mask{} == Mask{}, light.wi, light.distance,
              scatterEval<F>(scene_, event_, light.wi) * light.radiance * (weight * powerHeuristic(light.pdf, other)));
    }
    /// Offers the light in a direction that the event scatters to, where it looks there.
    PDR_HD void offerScattered() {
        const Mask looks = numbers_.looksAlong > 0.0f;
        if (!bothWays<F>(scene_) || !any(looks))
            return;
        const ScatteredOf<Real> along = scatterSample<F>(scene_, event_, numbers_.direction);
        const Real density = scatterPdf<F>(scene_, event_, along.wi);
        forLightsMet<F, Real>(scene_, place_, along.wi, [&](const FlatLight& light, const LightHitOf<Real>& hit) {
            offer(looks & hit.met, along.wi, hit.distance,
                  along.weight * light.radiance * powerHeuristic(density, hit.pdf));
        });
        if constexpr (has(F, kEnvironment))
            offer(looks, along.wi, Real{} + kFarAway,
                  along.weight * environmentRadiance(scene_.environment, along.wi) *
                      powerHeuristic(density, environmentPdf(scene_.environment, along.wi)));
    }

    /// Returns the chosen light path, shortened where clipped tissue casts no shadow.
    PDR_HD LightPathOf<Real> path() const {
        LightPathOf<Real> path{{origin_, scene_.volume.indexFromLocal * choice_.wi, choice_.distance},
                               choice_.radianceOfAll()};
        if (scene_.clip.count > 0 && !scene_.clip.shadows)
            path.ray.length = cutLength(scene_.clip, path.ray.origin, path.ray.direction, path.ray.length);
        if (scene_.unshadowed)
            path.ray.length = Real{};
        return path;
    }

  private:
    PDR_HD void offer(Mask mask, const Vec3<Real>& wi, Real distance, const Vec3<Real>& radiance) {
        const Real crossing = scene_.unshadowed ? Real{} + 1.0f : edgeTransmittance<F>(scene_, event_, wi);
        choice_.offer(mask, wi, distance, radiance * crossing);
    }

    const FlatScene& scene_;
    const EventOf<Real>& event_;
    const LightNumbersOf<Real>& numbers_;
    Vec3<Real> origin_;   ///< origin of rays from the event, index space
    Vec3<Real> place_{};  ///< the origin in local coordinates
    LightReservoir<Real> choice_;
};

/// Returns a path of light that reaches the event directly from a light and is scattered back along the camera path.
/// Every light is sampled, or some of very many (many_lights.h). Where it pays, light is also sampled along a direction
/// that the event scatters to: here, or by the path itself where it continues. Light that both techniques can find is
/// weighted by multiple importance sampling.
template <std::uint32_t F>
PDR_HD inline LightPath directLight(const FlatScene& scene, const Event& event, const Sampler& sampler, int bounce) {
    const LightNumbers numbers = lightNumbers<F>(scene, sampler, bounce);
    LightSearch<F, float> search(scene, event, numbers);
    forLightsLookedAt(scene, sampler, bounce,
                      [&](const FlatLight& light, float weight) { search.offerLight(light, weight); });
    if (has(F, kEnvironment) && scene.environment.texels != nullptr)
        search.offer(sampleEnvironment(scene.environment, sampler.pair(bounce, BounceDimension::environment),
                                       sampler.stream(bounce, BounceDimension::environment).pair()),
                     1);
    search.offerScattered();
    return search.path();
}

#if !defined(__CUDACC__)

/// Returns whether directLight() of lanes can be called: where all events look at the same lights.
inline bool lanesCanSeekLight(const FlatScene& scene) {
    return scene.lightSums == nullptr && scene.environment.texels == nullptr;
}

/// Returns for each lane what directLight() returns for one event, bit by bit.
template <std::uint32_t F>
LightPathOf<FloatLanes> directLight(const FlatScene& scene, const EventOf<FloatLanes>& event,
                                    const LightNumbersOf<FloatLanes>& numbers) {
    LightSearch<F, FloatLanes> search(scene, event, numbers);
    for (int i = 0; i < scene.lightCount; ++i)
        search.offerLight(scene.lights[i], 1);
    search.offerScattered();
    return search.path();
}

#endif

/// A segment of a path on which light is met.
template <class Real>
struct LitSegmentOf {
    Vec3<Real> origin;     ///< index space
    Vec3<Real> direction;  ///< unit, local
    Real pdf;              ///< with which the direction was sampled [1/sr]
    Real collision;        ///< mm to the event at its end; negative: it leaves the volume
};

/// Returns the light that a path meets on a segment: the radiance of the lights before the event at its end, and of the
/// environment if the segment leaves. It is weighted against directLight() at the event before, the other technique
/// that finds it. For lanes, as directLight().
template <std::uint32_t F, class Real>
PDR_HD inline Vec3<Real> lightOnSegment(const FlatScene& scene, const LitSegmentOf<Real>& segment) {
    using Mask = typename SimdTraits<Real>::Mask;
    Vec3<Real> radiance{}, place{};
    const auto add = [&](Mask mask, const Vec3<Real>& light) { radiance = chosen(mask, radiance + light, radiance); };
    if constexpr (has(F, kPlacedLights))
        place = localPosition(scene.volume, segment.origin);
    const Mask leaves = segment.collision < 0.0f;
    forLightsMet<F, Real>(scene, place, segment.direction, [&](const FlatLight& light, const LightHitOf<Real>& hit) {
        add(hit.met & (leaves | (hit.distance < segment.collision)),
            light.radiance * powerHeuristic(segment.pdf, hit.pdf));
    });
    if (has(F, kEnvironment) && any(leaves))
        add(leaves, environmentRadiance(scene.environment, segment.direction) *
                        powerHeuristic(segment.pdf, environmentPdf(scene.environment, segment.direction)));
    return radiance;
}

}  // namespace pdr
