#pragma once
/// One sample of one pixel traced again, alone, and told segment by segment: how a fault came about.

#include <vector>

#include "render/base/health.h"
#include "render/kernel/transport/integrator.h"
#include "render/prepare/prepared_scene.h"

namespace pdr {

/// Light that is looked for from an event.
struct ReplayedLight {
    vec3 radiance{0};         ///< that it adds to the sample where nothing is in its way; 0: none was found
    vec3 direction{0};        ///< unit, patient axes
    float distance = 0;       ///< mm
    float transmittance = 0;  ///< of the way to it, as estimated
};

/// A way of the path, and what it met at its end.
struct ReplayedSegment {
    dvec3 startMm{0};                   ///< patient space
    vec3 direction{0};                  ///< unit, patient axes
    float length = 0;                   ///< mm that it may go; <= 0: it misses the volume
    vec3 collected{0};                  ///< radiance that it adds: lights that it met on its way
    float collision = -1;               ///< mm to the event; < 0: none, the path leaves, and the rest below is empty
    dvec3 eventMm{0};                   ///< patient space
    float hu = 0;                       ///< there
    float extinction = 0;               ///< there [1/mm]
    Event event{};                      ///< a normal of 0: the phase function scatters
    vec3 emitted{0};                    ///< radiance that it adds to the sample
    std::vector<ReplayedLight> lights;  ///< one after the other
    vec3 throughput{1.0f};              ///< of the path after the event
};

struct Replay {
    std::vector<ReplayedSegment> segments;
    vec3 radiance{0.0f};  ///< the sample's, linear Rec. 709
    Health faults;
};

/// The sample that a rendering of `scene` takes as number `sample` of `pixel` (x, y; inside the film), bit by bit.
/// Scattering models only.
Replay replayed(const PreparedScene& scene, ivec2 pixel, std::uint64_t sample);

}  // namespace pdr
