#pragma once
/// How far away is what a pixel shows, and what is it?

#include <optional>

#include "render/prepare/prepared_scene.h"

namespace pdr {

/// Depth along the view [mm from the eye], through a pinhole, at which half of the light from `pixel` (x, y) has met an
/// event; nothing where less than half of it does, or outside the image.
std::optional<double> depthUnder(const PreparedScene& scene, ivec2 pixel);

/// What a pixel shows.
struct TissueUnder {
    float hu;      ///< mean of the first 2 mm behind the depth above: the edge itself is neither of its two sides
    float spread;  ///< standard deviation there [HU]
};

/// Likewise nothing where less than half of the light meets an event, or outside the image.
std::optional<TissueUnder> tissueUnder(const PreparedScene& scene, ivec2 pixel);

}  // namespace pdr
