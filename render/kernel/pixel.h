#pragma once
/// Pixels: what is known of them before a sample, and how samples are added to their sums.

#include "render/base/tile.h"
#include "render/kernel/flat_scene.h"

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

/// Whether the pixel shows nothing but a background that looks the same everywhere.
PDR_HD inline bool showsNothing(const FlatScene& scene, vec2 depths) {
    return depths.x > depths.y && scene.plainBackground;
}

}  // namespace pdr
