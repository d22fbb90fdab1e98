#pragma once
/// The grid that the frames of a segmentation lie in. Frames without voxels are often left out, and each segment has
/// frames of its own: places repeat and have gaps.

#include <vector>

#include "dicom/read/slice_header.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::dicom {

struct FrameGrid {
    VolumeGeometry geometry;
    std::vector<int> slice;  ///< index k of each frame
};

/// Returns the grid of `frames`, whose slices are those of `scan` if all frames lie on these, or else as far apart as
/// the nearest two. Errors: no place is stated; frames differ in direction or spacing of their pixels, or lie more than
/// 0.2 mm or a fifth of a step beside an even grid.
Result<FrameGrid> gridOfFrames(const std::vector<SliceHeader>& frames, const VolumeGeometry& scan);

}  // namespace pdr::dicom
