#pragma once
/// Pixels: what is known about them before the first sample, and how samples are added to their sums.

#include "render/base/tile.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

/// Returns why addSample() rejected `radiance`.
PDR_HD inline Fault faultOf(vec3 radiance) {
    for (int channel = 0; channel < 3; ++channel)
        if (!(radiance[channel] == radiance[channel]))
            return Fault::notANumber;
    for (int channel = 0; channel < 3; ++channel)
        if (radiance[channel] < 0)
            return Fault::negative;
    return Fault::infinite;
}

/// Adds sample number `sample`. Returns false, and adds nothing, where a channel of `radiance` is negative or no finite
/// number; faultOf() returns the reason.
PDR_HD_INLINE bool addSample(PixelSums& sums, vec3 radiance, std::uint64_t sample) {
    const float least = glm::min(glm::min(radiance.x, radiance.y), radiance.z);
    const float total = radiance.x + radiance.y + radiance.z;
    if (!(least >= 0 && total < 3e38f))
        return false;
    const dvec3 value(radiance);
    sums.sum += value;
    sums.sumOfSquares += value * value;
    ++sums.count;
    if (sample % 2 == 0) {
        sums.evenSum += radiance;
        ++sums.evenCount;
    }
    return true;
}

PDR_HD inline vec2 depthBounds(const FlatScene& scene, ivec2 pixel) {
    const FlatViewBounds& bounds = scene.viewBounds;
    return bounds.depths[(pixel.y / kViewBlock) * bounds.blocksPerRow + pixel.x / kViewBlock];
}

/// Returns whether a pixel shows only a background that is the same in every direction.
PDR_HD inline bool isBackgroundOnly(const FlatScene& scene, vec2 depths) {
    return depths.x > depths.y && scene.plainBackground;
}

/// Returns the bits of PixelSums::seen that are known before any sample is traced.
PDR_HD inline std::uint32_t seenAtFirst(const FlatScene& scene, vec2 depths) {
    return scene.lit && depths.x <= depths.y ? kSeenChance : 0;
}

}  // namespace pdr
