#pragma once
/// What regions say of a scan: the statistics of the voxels whose centres lie in them.

#include "app/plan/measured.h"

namespace pdr::app {

/// Returns the mean of the voxels in the ball about the first place, as far as the second.
Result<Measured> measuredBall(const std::vector<measure::Place>& places, const Volume& volume);

/// Returns the mean of the voxels in an ellipse (slice_region.h), and its area.
Result<Measured> measuredEllipse(const std::vector<measure::Place>& places, const Volume& volume);

}  // namespace pdr::app
