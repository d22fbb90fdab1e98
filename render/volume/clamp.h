#pragma once
/// Clamps the voxels of a volume to an interval.

#include <optional>
#include <utility>

#include "render/volume/volume.h"

namespace pdr {

/// Returns the volume with every voxel clamped to [first, second] HU, padding included; padding stays marked as
/// padding. Without an interval it returns the volume unchanged. If the volume is moved in, it needs no further memory.
/// Needs first <= second, both within int16.
Volume clamped(Volume volume, const std::optional<std::pair<int, int>>& interval);

}  // namespace pdr
