#pragma once
/// Renders tiles on the CPU with kernel/baseline/kroes_path.h, one sample after the other.

#include "render/base/tile.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

/// Adds `samples` to each pixel of `tile`. For scenes that are marched. sums.health must not be null.
void renderMarched(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums);

}  // namespace pdr
