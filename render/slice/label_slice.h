#pragma once
/// The labels on a plane through a label map.

#include <cstdint>
#include <vector>

#include "render/slice/slice_plane.h"
#include "render/volume/label_map.h"

namespace pdr {

/// Returns the label of the voxel that is nearest to each pixel's centre, row by row from the top; 0 outside the map.
std::vector<std::uint8_t> labelsOnPlane(const LabelMap& map, const SlicePlane& plane);

}  // namespace pdr
