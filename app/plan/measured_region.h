#pragma once
/// What regions say of a scan: the statistics of the voxels whose centres lie in them.

#include "app/plan/measured.h"

namespace pdr::app {

/// Returns the mean of the voxels in the ball about the first place, as far as the second.
Result<Measured> measuredBall(const std::vector<measure::Place>& places, const Volume& volume);

/// Returns the mean of the voxels in an ellipse (slice_region.h), and its area.
Result<Measured> measuredEllipse(const std::vector<measure::Place>& places, const Volume& volume);

/// Returns the area of a polygon, whose corners lie in one plane, and the mean of the voxels inside. Where they have
/// none, the details say why. Fails if the outline crosses itself or encloses nothing.
Result<Measured> measuredPolygon(const std::vector<measure::Place>& corners, const Volume& volume);

/// Returns what measuredPolygon() says if no scan is at hand: its area alone.
Result<Measured> areaOfPolygon(const std::vector<measure::Place>& corners);

}  // namespace pdr::app
