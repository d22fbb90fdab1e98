#pragma once
/// Finds vessels on a scan with contrast medium, by density and geometry, without learning or atlas: a guess.
///   1. blood: pools of at least 5 ml, uniform over 6 mm, from three quarters of the blood's HU on (blood_cells.h)
///   2. bone: cells that hang together with dense bone (bone_cells.h), above 1.4 times the blood's HU, more than 8 mm
///      from such a pool
///   3. veins full of undiluted medium: near a lung, what is above twice the blood's HU and 700 HU, holds balls of 3 mm
///      radius whose centres fill 0.5 ml, and comes within 8 mm of a pool; cortical bone is a shell
///   4. what lies between, above half of the blood's HU (from 150 to 210 HU), goes to the one of both whose flood
///      reaches it first (voxel_flood.h): vessels and bones part at the edge between them
///   5. in the lungs, 5 mm from the pleura, all that is above -250 HU: there is no bone
/// It fails where vessels and bone touch without an edge (neck, base of the skull), and for veins full of undiluted
/// medium that are thinner or far from the lungs. It takes calcium in a wall for a vessel or for bone, organs full of
/// medium, such as kidneys, for vessels, and walls of airways near the hila for vessels of the lung.

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_map.h"
#include "render/volume/volume.h"

namespace pdr::segment {

/// Returns a label map of `volume` with one part, "vessels", and notes where it may be wrong. The same for any number
/// of threads. Errors, of kind refused: values that are no HU, no contrast medium in the blood, or too little; else
/// cancelled(), and not enough memory.
Result<LabelMap> findVessels(const Volume& volume, const Progress& progress);

}  // namespace pdr::segment
