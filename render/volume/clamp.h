#pragma once
/// A volume with its values cut to an interval.

#include <optional>
#include <utility>

#include "render/volume/volume.h"

namespace pdr {

/// Every voxel clamped to [first, second] HU, padding included; what is padding stays so. Without an interval the
/// volume as it is. Moved in, it needs no memory of its own. Needs first <= second, both within int16.
Volume clamped(Volume volume, const std::optional<std::pair<int, int>>& interval);

}  // namespace pdr
