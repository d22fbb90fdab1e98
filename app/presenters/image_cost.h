#pragma once
/// What images cost in time, by those that were rendered before: in this run, or in an earlier one.

#include <optional>

#include "app/presenters/settings.h"
#include "render/session/session.h"
#include "ui/output/image_order.h"

namespace pdr::app {

/// Saves the time per pixel that planning quality took, for the next image of the frame's kind: device and look.
void keepPlanningTime(Settings& settings, const Frame& frame);

/// Returns the time until planning quality that the last image of the frame's kind took [s], for a film of `film`
/// pixels; none if there was none.
std::optional<double> lastPlanningTime(const Settings& settings, const Frame& frame, ivec2 film);

/// Estimates the cost of an image from the time that this one took, or else the last one of its kind; none if neither
/// is known.
std::optional<ui::ImageCost> costOf(const Settings& settings, const Frame& frame);

}  // namespace pdr::app
