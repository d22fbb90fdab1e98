#pragma once
/// The CPU's way through kernel/kroes_path.h: one sample after the other.

#include "render/base/tile.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

/// Adds `samples` to each pixel of `tile`. sums.health must be there. For scenes that are marched.
void renderMarched(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums);

}  // namespace pdr
