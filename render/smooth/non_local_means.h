#pragma once
/// A scan with less noise, for images only: nothing that states a value of the scan may read it.

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr {

/// Returns `volume` with the non-local means of each slice (slice_means.h) in place of its voxels, for noise of that
/// standard deviation, in the unit of the values. Slices do not mix, so that neither their distance nor a gantry's tilt
/// matters. Padding stays as it is. No voxel leaves the range of the stored values. It takes as much memory again as
/// the volume. Neither the number of threads nor that of lanes changes the result. A remark says that
/// it is denoised. Error: cancelled().
Result<Volume> nonLocalMeans(const Volume& volume, double noise, const Progress& progress);

/// Returns `volume` with the non-local means for the noise that is estimated from it (noise_level.h). Errors:
/// cancelled(); too little memory; values that are no HU, of whose noise nothing is known.
Result<Volume> ctDenoised(const Volume& volume, const Progress& progress);
/// Returns whether the remarks of `volume` say that it is denoised: "CT denoised".
bool isCtDenoised(const Volume& volume);

}  // namespace pdr
