#pragma once
/// Implants, by the density of metal: pieces of at least 0.05 ml of cells that hold a voxel above 2500 HU, and in them
/// and the cells beside them all voxels above 1500 HU, for the metal's blurred edge. A guess: fillings of teeth,
/// electrodes and undiluted contrast medium are as dense, and what metal blurs may be among it.

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_map.h"
#include "render/volume/volume.h"

namespace pdr::segment {

/// Returns a label map of `volume` with one part, "implant". The same for any number of threads. Errors, of kind
/// refused: those of bodyMask(), no metal in the body; else cancelled(), and not enough memory.
Result<LabelMap> findImplants(const Volume& volume, const Progress& progress);

}  // namespace pdr::segment
