#pragma once
/// Autofocus: how far away is what a pixel shows?

#include <optional>

#include "render/prepare/prepared_scene.h"

namespace pdr {

/// Depth along the view [mm from the eye], through a pinhole, at which half of the light from `pixel` (x, y) has met an
/// event; nothing where less than half of it does, or outside the image.
std::optional<double> depthUnder(const PreparedScene& scene, ivec2 pixel);

}  // namespace pdr
