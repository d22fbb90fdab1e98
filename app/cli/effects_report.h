#pragma once
/// What `pdrender-cli effects` says: what a picture calls for, what that costs, and what it would cost otherwise.

#include <optional>
#include <string>
#include <vector>

#include "render/device/device.h"
#include "render/session/effect_trial.h"

namespace pdr::app {

struct TriedEffect {
    Effect effect;
    std::optional<EffectTrial> trial;  ///< of what is needed and can be left out
};

struct TriedModel {
    Model model;
    CostBand milliseconds;  ///< per iteration
};

struct EffectsReport {
    ivec2 film{0};  ///< pixels of the small picture that was measured
    DeviceInfo device;
    Model model = Model::singleScattering;  ///< of the scene
    std::vector<TriedEffect> effects;
    std::vector<TriedModel> models;  ///< the same scene under each
};

/// "needed", "off" or "could be left out": an effect that shows nowhere in the picture, though it is looked for.
std::string verdictText(const TriedEffect& tried);

/// A table of effects and one of models. Milliseconds are processor time.
std::string plainText(const EffectsReport& report);

/// A JSON object: width, height, device, model; effects (name, verdict, reason; milliseconds and levels are null where
/// nothing was left out), models (name, milliseconds). milliseconds: low, median, high.
std::string jsonText(const EffectsReport& report);

}  // namespace pdr::app
