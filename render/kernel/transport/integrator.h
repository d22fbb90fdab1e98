#pragma once
/// The whole transport on one page, by Monte Carlo, without bias. It estimates the radiance that the camera sees along
/// a ray x(t) = x - t w (the volume rendering equation, Chandrasekhar 1950),
///
///   L(x, w) = int_0^d T(t) sigma_t(x(t)) [ c_e + a int_S2 f(w, w') L(x(t), w') dw' ] dt + T(d) L_background
///
///   T(t)      transmittance, exp(-int_0^t sigma_t ds)            track<RatioTracking>     Novak et al. 2014
///   sigma_t   extinction; T sigma_t is the pdf of the collision   track<DeltaTracking>     Woodcock et al. 1965
///             both up to the first event and its light            firstFlight              by inversion, or looks
///   c_e       emission per optical depth: its weight is 1, since the collision's pdf is T sigma_t    depart
///   a f       albedo and phase function, or a surface's BRDF with its cosine                  scatterEval, event.h
///   int_0^d   one event, or two on the first segment, whose flight is paid for once          firstFlight, Collisions
///   int_S2    next-event estimation of light from the lights, one light path by resampling (Talbot et al. 2005) with
///             multiple importance sampling (Veach & Guibas 1995)              directLight, lightOnSegment
///             and, with kBounces, one continuation of the path; Russian roulette keeps its mean    sampleContinuation
///
///   startPath -> traceSegment (track, endSegment, track towards the light) -> traceSegment -> ...
/// A path is a value that goes through these steps; a GPU's thread takes one at a time (traceSegment), the CPU many in
/// step (device/cpu/pixel_batch.h): both track rays in their own way and call endSegment and addLight in between. Light
/// that a path can meet where it goes on is collected there, with its weight beside next-event estimation.

#include "render/base/health.h"
#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/transport/direct_light.h"
#include "render/kernel/transport/event.h"
#include "render/kernel/transport/free_flight.h"
#include "render/kernel/transport/tracking.h"

namespace pdr {

/// One sample of one pixel, on its way to its next event.
struct Path {
    Sampler sampler;
    PathSegment segment;
    vec3 throughput{1.0f};  ///< fraction of radiance from the next event that reaches the camera
    float pdf = 0;          ///< pdf with which the last event found the segment's direction [1/sr]
};

PDR_HD inline Sampler pathSampler(const FlatScene& scene, ivec2 pixel, std::uint64_t sample) {
    return {*scene.sobol, scene.seed, std::uint32_t(pixel.y * scene.camera.film.x + pixel.x), sample};
}

/// `depths`: where tissue lies along the pixel's view; see FlatViewBounds.
PDR_HD_INLINE Path startPath(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths) {
    const Sampler sampler = pathSampler(scene, pixel, sample);
    const vec2 filter = sampler.pair(Dimension::filter);
    const vec2 lens = scene.camera.focus > 0 ? sampleUniformDisk(sampler.pair(Dimension::lens)) : vec2(0);
    return {sampler, generateCameraRay(scene, vec2(pixel) + filter, lens, depths)};
}

/// The first segment of a path flies, and so does the light of its event: one low-discrepancy number says how far. What
/// is behind is tracked, where no number would pay.
PDR_HD inline bool isFlown(int bounce) {
    return bounce == 0;
}

/// Events on a segment, with a light path from each. On the first there are two, a half of the light each: one flight
/// finds both. The path goes on from the last.
inline constexpr int kMostEvents = 2;
PDR_HD inline int eventsOn(int bounce) {
    return isFlown(bounce) ? kMostEvents : 1;
}
PDR_HD inline bool goesOnFrom(int event, int bounce) {
    return event + 1 == eventsOn(bounce);
}
/// Whether the two events lie at depths of their own. Where paths go on they are one event with two light paths: most
/// of its noise is that of the path behind it, which a second place would not lower.
PDR_HD inline bool eventsApart(const FlatScene& scene) {
    return scene.maxBounces <= 1;
}

/// Distances of the events on a segment [mm]; negative: the ray left the volume, NaN: see kMostSteps.
struct Collisions {
    float of[kMostEvents];
};

/// The optical depths to the events on a path's first segment, in the order in which a flight passes them.
struct EventDepths {
    float nearer, further;
    bool swapped;  ///< the flight passes event 1 first

    PDR_HD Collisions collisions(float near, float far) const {
        return swapped ? Collisions{far, near} : Collisions{near, far};
    }
};
PDR_HD inline EventDepths eventDepths(const FlatScene& scene, const Path& path) {
    const float first = path.sampler.depth(0), second = path.sampler.depth(eventsApart(scene) ? 1 : 0);
    return first > second ? EventDepths{second, first, true} : EventDepths{first, second, false};
}

/// The random numbers along a segment that is tracked, and along the light path from its end.
PDR_HD inline RandomStream distanceStream(const Path& path, int bounce) {
    return path.sampler.stream(bounce, BounceDimension::distance);
}
PDR_HD inline RandomStream shadowStream(const Path& path, int bounce) {
    return path.sampler.stream(bounce, BounceDimension::shadow);
}

/// Returns the sampler of event `i` on a segment.
PDR_HD inline Sampler eventSampler(const Path& path, int i, int bounce) {
    return path.sampler.branch(i, eventsOn(bounce));
}

/// The random numbers for the looks of a path's first flight, and of the flights from its end to the lights.
PDR_HD inline RandomStream lookStream(const Path& path) {
    return path.sampler.stream(0, BounceDimension::looks);
}
PDR_HD inline RandomStream lightLookStream(const Path& path, int event) {
    return eventSampler(path, event, 0).stream(0, BounceDimension::lightLooks);
}

/// The transmittance of a light path that flies, with Russian roulette where little is left: a flight of the
/// depth shadowDepth() ends there, and one that does not leaves shadowTransmittance().
inline constexpr float kShadowRouletteBelow = 0.2f;
PDR_HD inline float shadowDepth(const Path& path, int event) {
    return negativeLog(kShadowRouletteBelow * eventSampler(path, event, 0).number(0, BounceDimension::shadow));
}
PDR_HD inline float shadowTransmittance(float distance, float passed) {
    return distance >= 0 ? 0 : glm::max(attenuation(passed).left, kShadowRouletteBelow);
}

/// What the camera sees along a segment that meets no event.
PDR_HD inline vec3 background(const FlatScene& scene, const PathSegment& segment) {
    if (segment.light >= 0)
        return scene.lights[segment.light].radiance;
    return scene.environment.visible ? environmentRadiance(scene.environment, segment.direction)
                                     : scene.environment.behind;
}

/// What a segment that meets no event brings: the background, or no number where its ray came to no end (kMostSteps).
PDR_HD inline vec3 missed(const FlatScene& scene, const PathSegment& segment, float collision) {
    return collision < 0 ? background(scene, segment) : vec3(collision);
}

/// Returns what background() returns where it is the same in every direction.
PDR_HD inline vec3 plainBackground(const FlatScene& scene) {
    return scene.environment.visible ? scene.environment.zenith : scene.environment.behind;
}

/// Exact Russian roulette: little throughput goes on rarely and then counts for more, so that its mean stays.
PDR_HD inline bool russianRoulette(vec3& throughput, float u) {
    constexpr float kRouletteBelow = 0.25f;
    const float most = glm::max(glm::max(throughput.x, throughput.y), throughput.z);
    if (!(most < kRouletteBelow))  // what is not a number goes on, to be met and counted
        return true;
    if (u * kRouletteBelow >= most)
        return false;
    throughput *= kRouletteBelow / most;
    return true;
}

/// How a path continues from an event, or several in lanes.
template <class Real>
struct ContinuationOf {
    RayOf<Real> ray;
    Vec3<Real> direction;  ///< unit, local
    Vec3<Real> weight;     ///< fraction of the radiance from there that the event passes on, divided by the pdf
    Real pdf;              ///< density of the direction [1/sr]; 0 where no light is sought along it
};

/// Returns a continuation from `event`, sampled by three numbers. `findsLight`: the path collects the light on it.
template <std::uint32_t F, class Real>
PDR_HD inline ContinuationOf<Real> continuationFrom(const FlatScene& scene, const EventOf<Real>& event,
                                                    const Vec3<Real>& u, bool findsLight) {
    const ScatteredOf<Real> scattered = scatterSample<F>(scene, event, u);
    ContinuationOf<Real> onward;
    onward.weight = scattered.weight * edgeTransmittance<F>(scene, event, scattered.wi);
    onward.pdf =
        has(F, kPlacedLights | kEnvironment) && findsLight ? scatterPdf<F>(scene, event, scattered.wi) : Real{};
    const Vec3<Real> direction = scene.volume.indexFromLocal * scattered.wi;
    const Vec3<Real> origin = rayOrigin<F>(scene, event);
    onward.ray = {origin, direction, cutLength(scene.clip, origin, direction, Real{} + kFarAway)};
    onward.direction = scattered.wi;
    return onward;
}

/// Sends the path on to its next segment; false where it ends.
PDR_HD inline bool goOn(Path& path, const ContinuationOf<float>& onward, int bounce) {
    path.throughput *= onward.weight;
    path.pdf = onward.pdf;
    path.segment = {onward.ray, onward.direction};
    return russianRoulette(path.throughput, path.sampler.number(bounce, BounceDimension::roulette));
}

/// The path's next segment, away from `event`; false where it ends.
template <std::uint32_t F>
PDR_HD inline bool sampleContinuation(const FlatScene& scene, Path& path, const Event& event, int bounce) {
    const vec3 u = path.sampler.triple(bounce, BounceDimension::continuation);
    return goOn(path, continuationFrom<F>(scene, event, u, continuationFindsLight(scene, bounce)), bounce);
}

/// What happens at the end of a segment: light that starts at its events, light that is scattered there, and whether
/// the path, now on its next segment, goes on.
struct PathVertex {
    vec3 emitted[kMostEvents]{};         ///< radiance, linear Rec. 709
    LightPath scattered[kMostEvents]{};  ///< to be traced unless they are isDark()
    bool continues = false;
    bool cut = false;      ///< it would have gone on, but may not
    vec3 collected{0.0f};  ///< radiance of the lights that the segment met
};

/// Returns event `i` on a segment, at the distance `collision` [mm].
template <std::uint32_t F>
PDR_HD inline Event eventOf(const FlatScene& scene, const Path& path, int i, float collision, int bounce) {
    return eventAt<F>(scene, path.segment.ray.origin + path.segment.ray.direction * collision, -path.segment.direction,
                      eventSampler(path, eventsApart(scene) ? i : 0, bounce).number(bounce, BounceDimension::event));
}

/// Returns the fraction of the radiance from an event on a segment that reaches the camera.
PDR_HD inline vec3 shareOfEvent(const Path& path, int bounce) {
    return path.throughput / float(eventsOn(bounce));
}
/// Returns the light path `light` from an event as the camera sees it.
PDR_HD inline LightPath seen(const Path& path, LightPath light, int bounce) {
    light.radiance *= shareOfEvent(path, bounce);
    return light;
}

/// The result of a path.
struct PathSample {
    vec3 radiance{0.0f};        ///< linear Rec. 709
    bool overMajorant = false;  ///< see Fault
    bool cut = false;           ///< see Fault::cutPath
    bool tissue = false;        ///< it met some
};

/// note(fault) for each fault of a sample but that its radiance is none: that is seen where it is added (addSample).
template <class Note>
PDR_HD inline void noteFaults(const PathSample& sample, Note&& note) {
    if (sample.overMajorant)
        note(Fault::overMajorant);
    if (sample.cut)
        note(Fault::cutPath);
}

/// Returns whether a path collects the light that it meets on a segment.
template <std::uint32_t F>
PDR_HD inline bool collectsLight(const FlatScene& scene, int bounce, float collision) {
    return has(F, kBounces) && bounce > 0 && scene.lightAlongPath && collision == collision;
}
PDR_HD inline LitSegmentOf<float> litSegment(const Path& path, float collision) {
    return {path.segment.ray.origin, path.segment.direction, path.pdf, collision};
}

/// The end of a segment whose ray was tracked to `collision` [mm], one of its Collisions. The sample gets what the
/// segment itself brings; `collected` is the light on it, as the camera sees it. `bounce`: segments before this one.
/// Returns whether there is an event.
PDR_HD inline bool arrive(const FlatScene& scene, const Path& path, float collision, int bounce, PathSample& sample,
                          vec3 collected) {
    if (collision != collision || (bounce == 0 && collision < 0)) {
        sample.radiance += missed(scene, path.segment, collision) / float(eventsOn(bounce));
        return false;
    }
    sample.radiance += collected;
    if (collision < 0)
        return false;
    sample.tissue = true;
    return true;
}

/// What an event itself emits: the sample gets it. The event's pdf is T sigma_t and emission is counted per optical
/// depth, so emission has the weight 1.
template <std::uint32_t F>
PDR_HD inline vec3 addEmission(const Path& path, vec3 emission, int bounce, PathSample& sample) {
    const vec3 emitted = (has(F, kEmission) ? emission : vec3(0)) * shareOfEvent(path, bounce);
    sample.radiance += emitted;
    return emitted;
}

/// What follows the last event of a segment: the path, where it goes on, gets its next segment: goesOn() sends it
/// there, or returns false where it ends.
template <std::uint32_t F, class GoesOn>
PDR_HD inline void depart(const FlatScene& scene, int bounce, PathSample& sample, PathVertex& vertex, GoesOn&& goesOn) {
    if constexpr (has(F, kBounces)) {
        const bool alive = scene.maxBounces > 1 && goesOn();
        vertex.cut = alive && bounce + 1 >= scene.maxBounces;
        vertex.continues = alive && !vertex.cut;
    }
    sample.cut = vertex.cut;
}

/// All of it, and the events in between. The vertex, empty where nothing was met, holds the light paths that are still
/// to be traced (addLight) and whether the path goes on.
template <std::uint32_t F>
PDR_HD inline PathVertex endSegment(const FlatScene& scene, Path& path, const Collisions& collisions, int bounce,
                                    PathSample& sample) {
    PathVertex vertex;
    if (collectsLight<F>(scene, bounce, collisions.of[0]))
        vertex.collected = path.throughput * lightOnSegment<F>(scene, litSegment(path, collisions.of[0]));
    Event event;
    for (int i = 0; i < eventsOn(bounce); ++i) {
        if (!arrive(scene, path, collisions.of[i], bounce, sample, vertex.collected))
            continue;
        if (i == 0 || eventsApart(scene))
            event = eventOf<F>(scene, path, i, collisions.of[i], bounce);
        vertex.scattered[i] = seen(path, directLight<F>(scene, event, eventSampler(path, i, bounce), bounce), bounce);
        vertex.emitted[i] = addEmission<F>(path, event.material.emission, bounce, sample);
        if (goesOnFrom(i, bounce))
            depart<F>(scene, bounce, sample, vertex, [&] { return sampleContinuation<F>(scene, path, event, bounce); });
    }
    return vertex;
}

/// Light of `radiance` of which `transmittance` has reached the vertex. In full shadow not even infinite light counts.
PDR_HD inline void addLight(PathSample& sample, vec3 radiance, float transmittance) {
    if (transmittance != 0)
        sample.radiance += radiance * transmittance;
}

/// The rays of a path's first segment, which fly; see isFlown().
struct FlownRays {
    PDR_HD static Collisions collisions(const FlatScene& scene, const Path& path, int, PathSample&) {
        const EventDepths depths = eventDepths(scene, path);
        const Flight flight =
            firstFlight<FlightEnd::places>(scene, path.segment.ray, depths.nearer, lookStream(path), depths.further);
        return depths.collisions(flight.distance, flight.further);
    }
    PDR_HD static float transmittance(const FlatScene& scene, const Path& path, int, const LightPath& light, int number,
                                      PathSample&) {
        const Flight flight =
            firstFlight<FlightEnd::whether>(scene, light.ray, shadowDepth(path, number), lightLookStream(path, number));
        return shadowTransmittance(flight.distance, flight.passed);
    }
};

/// The rays of all further segments, which are tracked.
struct TrackedRays {
    PDR_HD static Collisions collisions(const FlatScene& scene, const Path& path, int bounce, PathSample& sample) {
        return {{track<DeltaTracking>(scene, path.segment.ray, distanceStream(path, bounce), sample.overMajorant)}};
    }
    PDR_HD static float transmittance(const FlatScene& scene, const Path& path, int bounce, const LightPath& light, int,
                                      PathSample& sample) {
        return track<RatioTracking>(scene, light.ray, shadowStream(path, bounce), sample.overMajorant);
    }
};

/// A visitor that records nothing.
struct NullVisitor {
    PDR_HD void segment(const Path&, int, const Collisions&) {}
    PDR_HD void light(const PathVertex&, const float*) {}
};

/// One segment of a path, and what is met at its end; false where the path ends. Rays: FlownRays or TrackedRays.
template <std::uint32_t F, class Rays, class Visitor>
PDR_HD_INLINE bool traceSegment(const FlatScene& scene, Path& path, int bounce, PathSample& sample, Visitor&& visitor) {
    const Collisions collisions = Rays::collisions(scene, path, bounce, sample);
    visitor.segment(path, bounce, collisions);
    const PathVertex vertex = endSegment<F>(scene, path, collisions, bounce, sample);
    float transmittances[kMostEvents]{};
    for (int i = 0; i < kMostEvents; ++i) {
        const LightPath& light = vertex.scattered[i];
        if (isDark(light))
            continue;
        transmittances[i] = Rays::transmittance(scene, path, bounce, light, i, sample);
        addLight(sample, light.radiance, transmittances[i]);
    }
    visitor.light(vertex, transmittances);
    return vertex.continues;
}

/// One sample of the radiance that the camera sees through `pixel` (x, y). `visitor` is told each segment with the
/// distances of its events (-1: none), and then the vertex there, empty where there is none, with the transmittances
/// of the ways to the light.
template <std::uint32_t F, class Visitor>
PDR_HD inline PathSample tracePath(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths,
                                   Visitor&& visitor) {
    Path path = startPath(scene, pixel, sample, depths);
    PathSample result;
    bool continues = traceSegment<F, FlownRays>(scene, path, 0, result, visitor);
    for (int bounce = 1; continues; ++bounce)
        continues = traceSegment<F, TrackedRays>(scene, path, bounce, result, visitor);
    return result;
}

}  // namespace pdr
