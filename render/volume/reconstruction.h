#pragma once
/// Interpolates slices between those of a scan. A renderer interpolates linearly between voxels, and where slices are
/// thick, the borders of tissue show steps. Additional slices from a cubic make these lower. For the renderer they are
/// voxels like others: bounds, exact flights and every device work with them unchanged.

#include "render/volume/volume.h"

namespace pdr {

enum class Reconstruction {
    linear,  ///< the voxels as they are
    cubic    ///< one more slice between each two, from the four around it
};

/// Returns `volume` with the voxels that `reconstruction` requests. The scan's own slices stay unchanged. At the
/// cubic's place t = 1/2 (Catmull & Rom 1974) their neighbours count 9/16, those behind -1/16; the outermost slices are
/// repeated. No voxel leaves the range of the stored HU; between padding and tissue there is padding. It takes twice
/// the memory, and for a moment three times. For a single slice, or `linear`, it returns the volume itself. An
/// interpolated volume has the remark "slices interpolated".
Volume reconstructed(Volume volume, Reconstruction reconstruction);
/// Returns whether the remarks of `volume` say that slices are interpolated.
bool hasInterpolatedSlices(const Volume& volume);

}  // namespace pdr
