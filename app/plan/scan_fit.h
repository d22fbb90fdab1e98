#pragma once
/// Whether the places of a plan that was read lie in the scan on which it was made.

#include "app/plan/plan.h"
#include "render/volume/volume.h"

namespace pdr::app {

/// Returns an error of kind refused that says which place of a measurement lies outside the voxels, and how far.
/// Rounding of 1e-6 voxels is let pass. A ball and an ellipse may reach beyond the scan: only their middles have to lie
/// in it.
Result<void> checkPlaces(const Plan& plan, const VolumeGeometry& geometry);

}  // namespace pdr::app
