#pragma once
/// Cost table of an image: for every effect, whether the scene needs it, what it costs and what it brings.

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/device/device.h"
#include "render/prepare/needs.h"
#include "render/scene/scene.h"
#include "render/session/effect_trial.h"

namespace pdr {

struct TriedEffect {
    Effect effect;
    std::optional<EffectTrial> trial;  ///< result if the effect can be tried; none: not measured yet
    bool ofViewBefore = false;         ///< the trial is that of an earlier view of the same scene

    /// Returns whether it is needed and can be left out, or is left out by choice and can be brought in.
    bool canBeTried() const { return effect.needed ? effect.leaveOut != nullptr : effect.bringIn != nullptr; }
    /// Returns whether rendering takes no longer without the effect and nobody would see a difference.
    bool couldBeLeftOut() const;
};

struct EffectCosts {
    ivec2 film{0};  ///< pixels of the small image that is measured
    DeviceInfo device;
    Model model = Model::singleScattering;  ///< model of the scene
    std::vector<TriedEffect> effects;       ///< in the order of needs()
    double seconds = 0;                     ///< processor time that measuring has taken
    bool complete = false;                  ///< all effects that can be tried have been, in the current view
    Text failure;                           ///< reason why measuring ended early; empty if nothing has failed
};

/// Fills the cost table of a scene, step by step.
class Calibration {
  public:
    /// Limits of the effort.
    struct Effort {
        int longestSide;  ///< longest side of the small image, at most [pixels]
        double seconds;   ///< processor time for all effects, approximate
    };

    /// `devices` must outlive this object, which has sole use of them.
    Calibration(Scene scene, const Display& display, const DevicePair& devices, const Effort& effort);

    bool isDone() const { return effectCosts_.complete; }
    /// Runs one launch. Errors: the device's. After a stop request the whole calibration is worthless.
    Result<void> step(const std::stop_token& stop = {});
    const EffectCosts& effectCosts() const { return effectCosts_; }
    /// Returns the scene with the film size of the ledger.
    const Scene& scene() const { return scene_; }

  private:
    Result<void> chooseFilm(const std::stop_token& stop);
    Result<void> tryNext(const std::stop_token& stop);
    double secondsEach() const;

    Scene scene_;
    Display display_;
    DevicePair devices_;
    Effort effort_;
    EffectCosts effectCosts_;
    std::size_t next_ = 0;  ///< index of the effect being tried
    std::unique_ptr<EffectTrying> trying_;
};

}  // namespace pdr
