#pragma once
/// Slices of a volume whose slices arrive one by one.

#include <limits>

#include "render/slice/reslice.h"
#include "render/volume/arriving_volume.h"

namespace pdr {

/// Stands in place of the HU where a slice of the volume has not arrived yet.
inline constexpr float kNotArrived = std::numeric_limits<float>::infinity();

/// Returns the slice of what has arrived of `volume` on `plane`: as reslice() of volume.h does, but kNotArrived where
/// the nearest of the volume's own slices is not there. Beside such a gap the last slice reaches half a slice into it,
/// as at the ends of a volume. None: a stop was requested, or the voxels were taken.
std::optional<SliceImage> reslice(const ArrivingVolume& volume, const SlicePlane& plane,
                                  const std::stop_token& stop = {}, std::vector<float> memory = {});

}  // namespace pdr
