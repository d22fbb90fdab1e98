#pragma once
/// Path tracing in kernels that do one thing each, so that 32 threads in lockstep do the same, and in few registers.
///
/// - CameraKernel<Kind, Thin>: a sample's camera ray and first flight. A queue: lanes take the next when one has
///   ended.
/// - ShadeKernel<F>: the end of that flight, and the events there (endSegment). One thread for each, so that all lanes
///   look for ends together; in the queue one or two would, while the others wait.
/// - ShadowKernel<Kind, Thin>: the flights from there to the lights. A queue, with an entry for each light path, so
///   that no lane waits for another's second one.
/// - AddLightKernel: the light that has come through. One thread for each event, in the order of its light paths.
/// - OnwardKernel<F>: all further segments of paths that continue, one after the other. A queue.
///
/// The kernels pass records in lists, in the order in which they come. No image depends on it: each record knows its
/// sample, and the light of a sample is added by one thread after the other, as traceSegment() does.

#include "render/device/gpu/trace_kernels.h"

namespace pdr {

/// The segment on which a flight ends.
struct alignas(16) FlightEnding {
    Cubic<float> hu;
    int piece;            ///< index of the curve's piece
    float begin, length;  ///< mm
    float left;           ///< optical depth to pass on it
};

/// Returns the distance at which a flight ends [mm].
PDR_HD inline float distanceOf(const FlatScene& scene, const FlightEnding& end) {
    const OpticsAlong<float> along = opticsAlong(scene.optics, opticsPiece(scene.optics, end.piece), end.hu);
    return end.begin + end.length * flightEndOn(along, end.length, end.left, true);
}

/// The first segment of a path, and the result of its flight.
struct FirstFlight {
    /// Where it passes the depths of its events, in Tissue::whole; in others the places are looked for in flight.
    FlightEnding nearer, further;
    PathSegment segment;
    /// Distances of the collisions, as in Flight. 0: it is at `nearer` or `further`, to be looked for.
    float nearerCollision, furtherCollision;
    std::int64_t index;  ///< index of the sample in its launch
};

/// A light path, and the flight along it.
struct ShadowFlight {
    LightPath light;
    float depth;  ///< optical depth; see shadowDepth()
    RandomStream random;
    Flight flown;  ///< result, without the distance: FlightEnd::whether
};

/// A vertex with the light paths that lead to its events.
struct LitVertex {
    ShadowFlight to[kMostEvents];
    std::int64_t place;  ///< place of the sample in TraceTarget::radiance
};

/// A path that continues behind its first vertex.
struct OnwardPath {
    Path path;
    PathSample found;  ///< sample so far, except its radiance, which is in the target
    TracedSample sample;
};

/// Lists for some samples of a launch, each with room for one record per sample.
struct PathLists {
    struct Counts {
        std::int32_t flights = 0, lit = 0, onward = 0;
    };
    FirstFlight* flights;
    LitVertex* lit;
    OnwardPath* onward;
    Counts* counts;
};

/// Traces the camera rays and first flights of samples. Kind: see PieceWalk. Thin: see FreeFlight.
template <Tissue Kind, ThinTissue Thin>
struct CameraKernel {
    static constexpr const char* kName = "camera";
    FlatScene scene;
    TraceTarget target;
    PathLists lists;
    std::int64_t first;  ///< index of the first of these samples in the launch

    struct Walk {
        FreeFlight<float, Kind, FlightEnd::places, Thin> flight;
        std::int32_t slot;
    };

    PDR_HD bool start(std::int64_t i, Walk& walk) const {
        TracedSample sample{};
        if (!target.at(first + i, sample))
            return false;
        const vec2 depths = depthBounds(scene, sample.from.pixel);
        if (isBackgroundOnly(scene, depths)) {
            target.keep(scene, sample, PathSample{.radiance = plainBackground(scene)});
            return false;
        }
        const Path path = startPath(scene, sample.from.pixel, sample.from.sample, depths);
        walk.slot = atomicTakeNext(lists.counts->flights);
        FirstFlight& flight = lists.flights[walk.slot];
        flight.segment = path.segment;
        flight.nearerCollision = flight.furtherCollision = -1;
        flight.index = first + i;
        const EventDepths events = eventDepths(scene, path);
        walk.flight.start(scene, path.segment.ray, events.nearer, lookStream(path));
        walk.flight.goOnTo(events.further);
        return walk.flight.going();
    }

    PDR_HD bool step(Walk& walk) const {
        FirstFlight& flight = lists.flights[walk.slot];
        if constexpr (Kind != Tissue::whole)
            walk.flight.step(scene);
        else
            walk.flight.step(scene, [&](const auto&, const auto& way, float left, bool) {
                (walk.flight.distance < 0 ? flight.nearer : flight.further) = {way.hu, way.piece.index, way.begin,
                                                                               way.length, left};
                return 0.0f;
            });
        if (walk.flight.going())
            return true;
        flight.nearerCollision = walk.flight.distance;
        flight.furtherCollision = walk.flight.further;
        return false;
    }
};

template <std::uint32_t F>
struct ShadeKernel {
    FlatScene scene;
    TraceTarget target;
    PathLists lists;

    PDR_HD void operator()(std::int64_t i) const {
        if (i >= lists.counts->flights)
            return;
        const FirstFlight& flight = lists.flights[i];
        TracedSample sample{};
        target.at(flight.index, sample);
        Path path{pathSampler(scene, sample.from.pixel, sample.from.sample), flight.segment};
        PathSample found;
        const float nearer = placeOf(flight.nearerCollision, flight.nearer);
        const float further = eventsApart(scene) ? placeOf(flight.furtherCollision, flight.further) : nearer;
        const Collisions collisions = eventDepths(scene, path).collisions(nearer, further);
        const PathVertex vertex = endSegment<F>(scene, path, collisions, 0, found);
        target.keep(scene, sample, found);
        handOnLight(path, vertex, sample.place);
        if (vertex.continues)
            lists.onward[atomicTakeNext(lists.counts->onward)] = {path, found, sample};
    }

    PDR_HD float placeOf(float collision, const FlightEnding& ending) const {
        return collision != 0 || isMasked(scene) || hasParts(scene) ? collision : distanceOf(scene, ending);
    }

    PDR_HD void handOnLight(const Path& path, const PathVertex& vertex, std::int64_t place) const {
        bool lit = false;
        for (const LightPath& light : vertex.scattered)
            lit = lit || !isDark(light);
        if (!lit)
            return;
        LitVertex& record = lists.lit[atomicTakeNext(lists.counts->lit)];
        record.place = place;
        for (int i = 0; i < kMostEvents; ++i) {
            const LightPath& light = vertex.scattered[i];
            record.to[i] = {light, isDark(light) ? 0 : shadowDepth(path, i), lightLookStream(path, i), {}};
        }
    }
};

/// Traces the light paths of all vertices. Kind, Thin: as for CameraKernel, or ThinTissue::allLooked.
template <Tissue Kind, ThinTissue Thin>
struct ShadowKernel {
    static constexpr const char* kName = "shadow";
    FlatScene scene;
    PathLists lists;

    struct Walk {
        FlightFor<float, Kind, FlightEnd::whether, Thin> flight;
        std::int32_t index;
    };

    /// Returns light path number `i`, counted vertex by vertex.
    PDR_HD ShadowFlight& at(std::int64_t i) const { return lists.lit[i / kMostEvents].to[i % kMostEvents]; }

    PDR_HD bool start(std::int64_t i, Walk& walk) const {
        if (i >= std::int64_t(lists.counts->lit) * kMostEvents || isDark(at(i).light))
            return false;
        walk.index = std::int32_t(i);
        walk.flight.start(scene, at(i).light.ray, at(i).depth, at(i).random);
        return goesOn(walk);
    }

    PDR_HD bool step(Walk& walk) const {
        walk.flight.step(scene);
        return goesOn(walk);
    }

  private:
    /// Returns whether the flight goes on, and records its result if not.
    PDR_HD bool goesOn(const Walk& walk) const {
        if (walk.flight.going())
            return true;
        at(walk.index).flown = {walk.flight.distance, walk.flight.passed};
        return false;
    }
};

/// Adds the light that reaches each vertex to its sample.
struct AddLightKernel {
    TraceTarget target;
    PathLists lists;

    PDR_HD void operator()(std::int64_t i) const {
        if (i >= lists.counts->lit)
            return;
        const LitVertex& vertex = lists.lit[i];
        PathSample sample{.radiance = target.radiance[vertex.place]};
        for (const ShadowFlight& flight : vertex.to)
            if (!isDark(flight.light))
                addLight(sample, flight.light.radiance,
                         shadowTransmittance(flight.flown.distance, flight.flown.passed));
        target.radiance[vertex.place] = sample.radiance;
    }
};

template <std::uint32_t F>
struct OnwardKernel {
    static constexpr const char* kName = "onward";
    FlatScene scene;
    TraceTarget target;
    PathLists lists;

    struct Walk {
        OnwardPath at;
        int bounce;
    };

    PDR_HD bool start(std::int64_t i, Walk& walk) const {
        if (i >= lists.counts->onward)
            return false;
        walk.at = lists.onward[i];
        walk.at.found.radiance = target.radiance[walk.at.sample.place];
        walk.bounce = 1;
        return true;
    }

    PDR_HD_INLINE bool step(Walk& walk) const {
        if (traceSegment<F, TrackedRays>(scene, walk.at.path, walk.bounce++, walk.at.found, NullVisitor()))
            return true;
        target.keep(scene, walk.at.sample, walk.at.found);
        return false;
    }
};

}  // namespace pdr
