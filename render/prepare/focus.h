#pragma once
/// The depth and the tissue that a pixel shows.

#include <optional>

#include "render/prepare/prepared_scene.h"

namespace pdr {

/// Returns the depth along the view [mm from the eye], through a pinhole, at which half of the light from `pixel` (x,
/// y) has met an event; nothing if less than half of it meets one, or outside the image.
std::optional<double> depthUnder(const PreparedScene& scene, ivec2 pixel);

/// The tissue that a pixel shows.
struct TissueUnder {
    /// Mean of the first 2 mm behind the depth that depthUnder() returns: HU at the edge itself belong to neither side.
    float hu;
    float spread;  ///< standard deviation over these 2 mm [HU]
};

/// Returns the tissue under `pixel` (x, y); nothing if less than half of the light meets an event, or outside the
/// image.
std::optional<TissueUnder> tissueUnder(const PreparedScene& scene, ivec2 pixel);

}  // namespace pdr
