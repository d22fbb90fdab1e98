#pragma once
/// Traces one sample of one pixel again and records it segment by segment, to show how a fault came about.

#include <vector>

#include "render/base/health.h"
#include "render/kernel/transport/integrator.h"
#include "render/prepare/prepared_scene.h"

namespace pdr {

/// A light that was sampled from an event.
struct ReplayedLight {
    vec3 radiance{0};         ///< radiance that it adds to the sample if nothing is in its way; 0: none was found
    vec3 direction{0};        ///< unit, patient axes
    float distance = 0;       ///< mm
    float transmittance = 0;  ///< estimated transmittance of the way to it
};

/// An event on a segment.
struct ReplayedEvent {
    float collision = -1;   ///< mm to the event; < 0: none, the ray leaves, and the rest below is empty
    dvec3 placeMm{0};       ///< patient space
    float hu = 0;           ///< Hounsfield units there
    float extinction = 0;   ///< extinction there [1/mm]
    Event event{};          ///< a normal of 0: the phase function scatters
    vec3 emitted{0};        ///< radiance that it adds to the sample
    ReplayedLight light{};  ///< light sampled from it
};

/// A segment of the path. The path goes on from the last of its events.
struct ReplayedSegment {
    dvec3 startMm{0};   ///< patient space
    vec3 direction{0};  ///< unit, patient axes
    float length = 0;   ///< length that it may go [mm]; <= 0: it misses the volume
    vec3 collected{0};  ///< radiance of the lights that it met on its way
    std::vector<ReplayedEvent> events;
    vec3 throughput{1.0f};  ///< throughput of the path behind it
};

struct Replay {
    std::vector<ReplayedSegment> segments;
    vec3 radiance{0.0f};  ///< radiance of the sample, linear Rec. 709
    Health faults;
};

/// Replays the sample that a rendering of `scene` takes as number `sample` of `pixel` (x, y; inside the film), bit by
/// bit. Scattering models only.
Replay replayed(const PreparedScene& scene, ivec2 pixel, std::uint64_t sample);

}  // namespace pdr
