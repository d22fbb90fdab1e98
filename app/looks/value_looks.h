#pragma once
/// Looks for volumes whose values are no HU. Curves that were drawn in HU would be wrong there, so these follow the
/// values themselves: whatever they measure, the most frequent low ones are transparent, and the highest are bright.

#include <vector>

#include "render/scene/named_look.h"
#include "render/volume/volume.h"

namespace pdr::app {

/// How the voxels of a volume are spread, padding left out; ascending.
struct ValueSpread {
    double low = 0;        ///< 0.1 % of the voxels lie below
    double threshold = 0;  ///< between the dark ones and the bright ones, by Otsu's rule (IEEE SMC-9, 1979)
    double high = 1;       ///< 0.1 % of the voxels lie above; at least low + 1

    bool operator==(const ValueSpread&) const = default;
};

/// Returns the spread of the voxels of `volume`.
ValueSpread spreadOf(const Volume& volume);

/// Returns the looks for voxels of that spread: grey and ever denser from the threshold on, and the brightest voxel of
/// each ray. Lights and all else are those of `drawn`.
std::vector<NamedLook> valueLooks(const ValueSpread& spread, const NamedLook& drawn);

}  // namespace pdr::app
