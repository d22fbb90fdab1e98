#pragma once
/// The HU along a distance, as the list of measurements shows them.

#include <optional>

#include "app/plan/measurement.h"
#include "render/volume/volume.h"
#include "ui/measure/profile_chart.h"

namespace pdr::app {

/// Returns the HU along the line of a distance and 5 mm beyond either end, so that both sides of an edge are seen. None
/// for other kinds, and for a distance without a length.
std::optional<ui::ShownProfile> profileOf(const Measurement& measurement, const Volume& volume);

}  // namespace pdr::app
