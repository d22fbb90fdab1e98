#pragma once
/// Marks what is measured across a hole of the scan (render/volume/holes.h): it depends on slices that were not
/// measured, of which its ± knows nothing.

#include <span>

#include "app/plan/measured.h"
#include "render/volume/holes.h"

namespace pdr::app {

/// Marks `measured`, in its text and its details, if one of these reaches into one of `holes`: a line of `measurement`,
/// its place, its outline, a voxel of its region.
Measured markedForHoles(Measured measured, const Measurement& measurement, std::span<const Hole> holes);

}  // namespace pdr::app
