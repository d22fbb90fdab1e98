#pragma once
/// Watershed between markers: which of several tissues a voxel belongs to, where their borders are the steepest.

#include <cstdint>

#include "render/base/huge_pages.h"
#include "render/segment/checkpoint.h"
#include "render/volume/volume.h"

namespace pdr::segment {

/// A mark for each voxel of a volume, x fastest.
using Marks = HugePageVector<std::uint8_t>;

inline constexpr std::uint8_t kOpen = 0;     ///< not known yet: to be flooded
inline constexpr std::uint8_t kWall = 0xFF;  ///< none of the tissues: never flooded

/// Gives the open voxels that are connected with a marker (any other mark) the mark of the one whose flood reaches
/// them first; the others stay open. Floods rise by the gradient of `hu`, smoothed over 3 x 3 voxels of the slice: even
/// tissue fills first, and floods meet at edges (Meyer's algorithm). One thread does it, so that the result is the same
/// everywhere; it takes time for open voxels alone.
void flood(const Volume& hu, Marks& marks, const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
