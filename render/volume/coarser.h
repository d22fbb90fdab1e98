#pragma once
/// A scan with fewer voxels, for pictures so small that nobody could tell.

#include "render/volume/volume.h"

namespace pdr {

/// `volume` in blocks of whole voxels with edges as near to `edgeMm` as can be, each the mean of its voxels; what is
/// left at the end of an axis is left out. Padding counts as air. The same for any number of threads.
Volume coarser(const Volume& volume, double edgeMm);

}  // namespace pdr
