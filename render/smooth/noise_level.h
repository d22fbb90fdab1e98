#pragma once
/// The noise of a scan, estimated from its own voxels.

#include "render/volume/volume.h"

namespace pdr {

/// Returns the standard deviation of the noise in the slices of `volume`, in the unit of its values; 0 where none can
/// be estimated.
///
/// It is a low quantile of the deviations in blocks of 8 x 8 voxels of a slice whose mean lies above that of the whole
/// scan: that leaves out air and lungs, in HU as in any other unit. Most of the remaining blocks hold an edge of
/// tissue; the smooth ones are the low end. Blocks with padding are left out, and blocks of one value: a scanner
/// measures none. The number of threads does not change the result.
double noiseOf(const Volume& volume);

}  // namespace pdr
