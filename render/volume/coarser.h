#pragma once
/// Reduces the voxels of a scan, for images so small that the difference is not visible.

#include "render/volume/label_map.h"
#include "render/volume/volume.h"

namespace pdr {

/// Returns `volume` in blocks of whole voxels with edges as near to `edgeMm` as possible, each the mean of its voxels.
/// Voxels that are left at the end of an axis are dropped. Padding counts as air. The number of threads does not change
/// the result.
Volume coarser(const Volume& volume, double edgeMm);

/// Returns the labels of the blocks of which coarser() made `blocks` on the map's grid: that of the voxel in the
/// middle.
LabelMap coarser(const LabelMap& map, const VolumeGeometry& blocks);

}  // namespace pdr
