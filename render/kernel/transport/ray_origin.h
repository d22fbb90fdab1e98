#pragma once
/// Where rays leave an event, and the light that they lose before they start. A surface in a CT has a soft edge about
/// two voxels wide. Events lie at many depths in it, and rays that start there are shadowed by the edge itself, by an
/// amount that follows the grid of voxels: rings like those of wood, which no number of samples removes. With
/// RayOrigin::outsideEdge they start outside it and lose what a plane edge takes on average.

#include "render/kernel/clip.h"
#include "render/kernel/transport/event.h"

namespace pdr {

/// Returns where the rays of an event start (index space): at the event, or, if it is on a surface and the scene says
/// so, one voxel out along the normal, but never beyond a clip plane.
template <std::uint32_t F>
PDR_HD inline vec3 rayOrigin(const FlatScene& scene, const Event& event) {
    if (!scene.raysStartOutside || !isSurface<F>(event))
        return event.position;
    const vec3 across = glm::normalize(scene.volume.indexFromLocal * event.normal);
    return event.position + across * glm::max(cutLength(scene.clip, event.position, across, 1.0f), 0.0f);
}

/// Returns the mean fraction of light that crosses a plane edge to the events in it. `view`, `light`: cosines of both
/// directions with its normal; `view` is not negative. Events at the optical depth t below the edge are seen with the
/// pdf exp(-t / view) / view, and exp(-t / light) of the light reaches them.
PDR_HD inline float edgeTransmittance(float view, float light) {
    return light > 0 ? light / (light + view) : 1.0f;
}

/// Returns the fraction of light from `wi` (unit, local) that reaches an event from rayOrigin().
template <std::uint32_t F>
PDR_HD inline float edgeTransmittance(const FlatScene& scene, const Event& event, vec3 wi) {
    if (!scene.raysStartOutside || !isSurface<F>(event))
        return 1;
    return edgeTransmittance(glm::dot(event.normal, event.wo), glm::dot(event.normal, wi));
}

}  // namespace pdr
