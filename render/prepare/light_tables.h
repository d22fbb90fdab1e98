#pragma once
/// Tables with which an event and a ray consider only few of very many lights; see kernel/transport/many_lights.h.

#include <span>
#include <vector>

#include "render/kernel/flat_scene.h"

namespace pdr {

struct LightTables {
    /// One more entry than lights: cumulative picking weights, how much light the lights before bring to the volume.
    std::vector<float> sums;
    std::vector<FlatLightNode> nodes;  ///< tree of bounding spheres of the rectangles and spheres
};

/// Returns the tables; empty if no more than kMostLightsInTurn lights shine.
LightTables lightTables(std::span<const FlatLight> lights, const FlatVolume& volume);

}  // namespace pdr
