#pragma once
/// Scenes whose light is easy and hard to find: what forecasts are held against.

#include <vector>

#include "app/bench/trackers/scenes.h"

namespace pdr::bench {

/// A lit head, skin and bone: as it is, through a wide lens, as forward-scattering fog, under a small bright lamp, and
/// with many bounces.
std::vector<NamedScene> predictionScenes();

}  // namespace pdr::bench
