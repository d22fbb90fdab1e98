#pragma once
/// What stands between the slices of a scan. A renderer interpolates linearly between voxels, and where slices are
/// thick the border of tissue is seen to have steps. Slices that a cubic puts between them make these lower, and to the
/// renderer they are voxels like others: bounds, exact flights and every device hold for them.

#include "render/volume/volume.h"

namespace pdr {

enum class Reconstruction {
    linear,  ///< the voxels as they are
    cubic    ///< one slice more between each two, from four around it
};

/// `volume` with the voxels that `reconstruction` asks for. The scan's own slices stay as they are; at the cubic's
/// place t = 1/2 (Catmull & Rom 1974) their neighbours count 9/16, those behind -1/16, the outermost slices being
/// repeated. No voxel leaves the range of the stored HU; between padding and tissue there is padding. Takes twice the
/// memory, and for a moment three times; of a single slice, or linear, it is the volume itself. Remarks say "slices
/// interpolated".
Volume reconstructed(Volume volume, Reconstruction reconstruction);
/// Whether its remarks say so.
bool hasInterpolatedSlices(const Volume& volume);

}  // namespace pdr
