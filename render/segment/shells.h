#pragma once
/// Parts that lie around others: skin, and muscle. Rules of density and geometry that need no contrast medium.
///   skin    what lies at most 2 mm below the surface of the body (body_mask.h), from outside inwards
///   muscle  soft tissue of -20 to 120 HU below it, smoothed over 3 x 3 voxels, that is no bone (bone_cells.h)

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_map.h"
#include "render/volume/volume.h"

namespace pdr::segment {

/// Returns a label map of `volume` with the parts "skin" and "muscle", and a note that muscle is guessed: organs and
/// marrow may have its density. `taken`: null, or parts on the same grid; their voxels stay free. The same for any
/// number of threads. Errors: those of bodyMask(), of kind refused; else cancelled(), and not enough memory.
Result<LabelMap> findShells(const Volume& volume, const LabelMap* taken, const Progress& progress);

}  // namespace pdr::segment
