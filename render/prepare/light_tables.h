#pragma once
/// What an event and a ray need to know to ask few of very many lights; see kernel/transport/many_lights.h.

#include <span>
#include <vector>

#include "render/kernel/flat_scene.h"

namespace pdr {

struct LightTables {
    std::vector<float> sums;           ///< one more than there are lights: what the lights before bring to the volume
    std::vector<FlatLightNode> nodes;  ///< a tree of balls around the lights that have a place
};

/// Empty where no more than kMostLightsInTurn lights shine.
LightTables lightTables(std::span<const FlatLight> lights, const FlatVolume& volume);

}  // namespace pdr
