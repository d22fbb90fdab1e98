#pragma once
/// Lays a label map onto the grid of a scan, or says why it does not belong there.

#include "render/base/result.h"
#include "render/volume/label_map.h"

namespace pdr {

/// What may happen to labels on a grid of other voxels than the scan's.
enum class Resampling {
    refused,
    nearest,  ///< each voxel of the scan takes the label of the nearest voxel of the map
};

/// Returns `map` on the grid `scan`. A map whose voxels are voxels of the scan, within a fifth of one and 0.2 mm, is
/// taken as it is, whatever the order of its axes; it may cover a part of the scan only. Another grid that lies within
/// the scan is resampled if that is asked for, which a note says. Errors, of kind refused, each with what to do next:
///   mirrored   it would fit with sides exchanged, or a part named "left" lies at the right of its counterpart
///   shifted    voxels like the scan's, but beside them: half a voxel is what programs that count from corners are off
///   elsewhere  it reaches beyond the scan: another scan, or another patient
///   other grid its voxels are others than the scan's, and resampling was not asked for
Result<LabelMap> labelsOn(const VolumeGeometry& scan, LabelMap map, Resampling resampling);

}  // namespace pdr
