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
template <std::uint32_t F, class Real>
PDR_HD inline Vec3<Real> rayOrigin(const FlatScene& scene, const EventOf<Real>& event) {
    const auto surface = isSurface<F>(event);
    if (!scene.raysStartOutside || !any(surface))
        return event.position;
    const Vec3<Real> across = normalize(scene.volume.indexFromLocal * event.normal);
    const Real outwards = max(Real{}, cutLength(scene.clip, event.position, across, Real{} + 1.0f));
    return chosen(surface, event.position + across * outwards, event.position);
}

/// Returns the mean fraction of light that crosses a plane edge to the events in it. `view`, `light`: cosines of both
/// directions with its normal; `view` is not negative. Events at the optical depth t below the edge are seen with the
/// pdf exp(-t / view) / view, and exp(-t / light) of the light reaches them.
template <class Real>
PDR_HD inline Real edgeTransmittance(Real view, Real light) {
    return light > 0.0f ? light / (light + view) : Real{} + 1.0f;
}

/// Returns the fraction of light from `wi` (unit, local) that reaches an event from rayOrigin().
template <std::uint32_t F, class Real>
PDR_HD inline Real edgeTransmittance(const FlatScene& scene, const EventOf<Real>& event, const Vec3<Real>& wi) {
    const auto surface = isSurface<F>(event);
    if (!scene.raysStartOutside || !any(surface))
        return Real{} + 1.0f;
    const Real transmitted = edgeTransmittance(dot(event.normal, event.wo), dot(event.normal, wi));
    return surface ? transmitted : Real{} + 1.0f;
}

}  // namespace pdr
