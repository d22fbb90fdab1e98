#pragma once
/// Whether a plan that was read belongs to the scan that is open: made on its voxels, and with all places in them.

#include "app/plan/plan_file.h"

namespace pdr::app {

/// Returns whether a place lies in the voxels, out to their faces. Rounding of 1e-6 voxels is let pass.
bool liesIn(const VolumeGeometry& geometry, dvec3 placeMm);

/// Returns an error of kind refused that says in what `volume` differs from the plan's scan (checkIsScanOf()), or which
/// place of a measurement lies outside it, and how far. What is measured in a region may reach beyond the scan: of a
/// ball, only the middle has to lie in it.
Result<void> checkFits(const SavedPlan& saved, const Volume& volume);

}  // namespace pdr::app
