#pragma once
/// All samples of one pixel, added to its sums in order.

#include "render/film/tile.h"
#include "render/kernel/integrator.h"

namespace pdr {

/// NaN, infinite and negative samples are left out and counted; they never become black.
PDR_HD inline void addSample(PixelSums& sums, vec3 radiance) {
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

template <std::uint32_t F>
PDR_HD inline void renderPixel(const FlatScene& scene, ivec2 pixel, SampleRange samples, PixelSums& sums) {
    const FlatViewBounds& bounds = scene.viewBounds;
    const vec2 depths = bounds.depths[(pixel.y / kViewBlock) * bounds.blocksPerRow + pixel.x / kViewBlock];
    PixelSums local = sums;
    if (depths.x > depths.y) {  // nothing but background
        for (std::uint32_t i = 0; i < samples.count; ++i)
            addSample(local, scene.environment * scene.environmentVisible);
    } else {
        for (std::uint32_t i = 0; i < samples.count; ++i)
            addSample(local, tracePath<F>(scene, pixel, samples.first + i, depths));
    }
    sums = local;
}

}  // namespace pdr
