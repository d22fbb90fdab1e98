#pragma once
/// The voxels of resampled slices.

#include <cstddef>
#include <span>
#include <vector>

#include "dicom/series.h"

namespace pdr::dicom {

/// Slices one after the other, with a flag for each voxel that is padding; no flags: none is.
struct FlaggedVoxels {
    Voxels hu;
    std::vector<bool> padding;
};

/// Returns the slices that `blends` makes of the measured ones, each of `perSlice` voxels: linear, rounded to whole HU.
/// What lies between a measured voxel and padding was not measured: it is padding, too, and air.
FlaggedVoxels blended(const FlaggedVoxels& measured, std::size_t perSlice, std::span<const SliceBlend> blends);

}  // namespace pdr::dicom
