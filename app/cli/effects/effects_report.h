#pragma once
/// Output of `pdrender-cli effects`: the effects that an image needs, their cost, and the cost of the other models.

#include <string>
#include <vector>

#include "render/session/effect_costs.h"

namespace pdr::app {

struct TriedModel {
    Model model;
    CostBand milliseconds;  ///< cost per iteration
};

struct EffectsReport {
    EffectCosts effectCosts;
    std::vector<TriedModel> models;  ///< costs of the scene under each model
};

/// Returns "needed", "off", "left out" (by choice: the image would change with it) or "could be left out". The last is
/// an effect that is enabled but changes nothing visible.
std::string verdictText(const TriedEffect& tried);

/// Returns a table of all effects, including those that are off, and a table of models. Milliseconds are processor
/// time.
std::string plainText(const EffectsReport& report);

/// Returns a JSON object: width, height, device, model, seconds (processor time of the measurement), effects, and
/// models (name, milliseconds). An effect has its name, verdict and reason, and these figures, which are null if it is
/// off, cannot be left out, or was not measured:
///   milliseconds           cost per iteration: low, median, high
///   share                  share of an iteration's time, 1 is all of it: low, median, high
///   meanLevels, levels95   change of the image without it, mean and 95th percentile [display levels]: value, low, high
///   timeWithout            time to any target without it, 1 is as long as with it: value, low, high
/// Low and high of the last three rows are 95 % intervals. Those of the first two rows are the smallest and the largest
/// value in six measurements.
std::string jsonText(const EffectsReport& report);

}  // namespace pdr::app
