#pragma once
/// Samples, and how they are added to a pixel's sums.

#include "render/base/tile.h"
#include "render/kernel/integrator.h"
#include "render/kernel/tracking.h"

namespace pdr {

/// NaN, infinite and negative samples are left out and counted; they never become black.
PDR_HD_INLINE void addSample(PixelSums& sums, vec3 radiance) {
    const float total = radiance.x + radiance.y + radiance.z;
    if (!(glm::min(glm::min(radiance.x, radiance.y), radiance.z) >= 0 && total < 3e38f)) {
        ++sums.rejected;
        return;
    }
    const dvec3 value(radiance);
    sums.sum += value;
    sums.sumOfSquares += value * value;
    ++sums.count;
}

PDR_HD inline vec2 matterDepths(const FlatScene& scene, ivec2 pixel) {
    const FlatViewBounds& bounds = scene.viewBounds;
    return bounds.depths[(pixel.y / kViewBlock) * bounds.blocksPerRow + pixel.x / kViewBlock];
}

PDR_HD inline bool meetsNothing(vec2 depths) {
    return depths.x > depths.y;
}

/// One sample of the radiance [linear Rec. 709] that the camera sees through `pixel` (x, y).
template <std::uint32_t F>
PDR_HD inline vec3 tracePath(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths) {
    const Path path = cameraStart(scene, pixel, sample, depths);
    const float collision =
        track<DeltaTracking>(scene, path.camera.ray, path.random.stream(0, BounceDimension::flight));
    if (collision < 0)
        return background(scene);
    const Arrival met = arrival<F>(scene, path, collision);
    if (isDark(met.scattered))
        return met.emitted;
    const RandomStream shadow = path.random.stream(0, BounceDimension::shadow);
    return met.emitted + met.scattered.radiance * track<RatioTracking>(scene, met.scattered.ray, shadow);
}

}  // namespace pdr
