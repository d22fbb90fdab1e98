#pragma once
/// What `pdrender-cli effects` says: what a picture calls for, what that costs, and what it would cost otherwise.

#include <string>
#include <vector>

#include "render/session/effect_ledger.h"

namespace pdr::app {

struct TriedModel {
    Model model;
    CostBand milliseconds;  ///< per iteration
};

struct EffectsReport {
    EffectLedger ledger;
    std::vector<TriedModel> models;  ///< the same scene under each
};

/// "needed", "off" or "could be left out": an effect that shows nowhere in the picture, though it is looked for.
std::string verdictText(const TriedEffect& tried);

/// A table of effects, one of what is off, and one of models. Milliseconds are processor time.
std::string plainText(const EffectsReport& report);

/// A JSON object: width, height, device, model, seconds (of processor time that measuring took); effects; models (name,
/// milliseconds). Of each effect its name, verdict and reason, and, null where it is off, cannot be left out, or is not
/// known:
///   milliseconds        per iteration that it costs: low, median, high
///   share               of an iteration's time, 1 is all: low, median, high
///   meanLevels, levels95   by which the picture changes without it, mean and 95th percentile: value, low, high
///   timeWithout         to any target without it, 1 is as long as with it: value, low, high
/// Low and high of the last three hold the truth in 95 of 100 cases; those of the first two are the smallest and the
/// largest of six.
std::string jsonText(const EffectsReport& report);

}  // namespace pdr::app
