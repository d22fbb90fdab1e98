#pragma once
/// What the seconds of a picture go to: every effect, whether the scene calls for it, what it costs and what it brings.

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
    std::optional<EffectTrial> trial;  ///< of what is needed and can be left out; none: not measured yet
    bool ofViewBefore = false;         ///< the trial is of the same scene as it was seen before

    bool canBeTried() const { return effect.needed && effect.leaveOut != nullptr; }
    /// Without it rendering takes no longer, and nobody would see a difference.
    bool couldBeLeftOut() const;
};

struct EffectLedger {
    ivec2 film{0};  ///< pixels of the small picture that is measured
    DeviceInfo device;
    Model model = Model::singleScattering;  ///< of the scene
    std::vector<TriedEffect> effects;       ///< as needs() has them
    double seconds = 0;                     ///< of processor time that measuring has taken
    bool complete = false;                  ///< all that can be tried is, as the scene is seen now
    Text failure;                           ///< why no more will be known; empty: nothing has failed
};

/// Fills the ledger of a scene, step by step.
class Calibration {
  public:
    /// How much may be spent.
    struct Effort {
        int longestSide;  ///< of the small picture, at most [pixels]
        double seconds;   ///< of processor time, about, for all effects
    };

    /// `devices` must outlive it, and are its own meanwhile.
    Calibration(Scene scene, const Display& display, const DevicePair& devices, const Effort& effort);

    bool isDone() const { return ledger_.complete; }
    /// One launch. Errors: those of the device. After a stop request all of it is worthless.
    Result<void> step(const std::stop_token& stop = {});
    const EffectLedger& ledger() const { return ledger_; }
    /// With the film of the ledger.
    const Scene& scene() const { return scene_; }

  private:
    Result<void> chooseFilm(const std::stop_token& stop);
    Result<void> tryNext(const std::stop_token& stop);
    double secondsEach() const;

    Scene scene_;
    Display display_;
    DevicePair devices_;
    Effort effort_;
    EffectLedger ledger_;
    std::size_t next_ = 0;  ///< effect that is tried
    std::unique_ptr<EffectTrying> trying_;
};

}  // namespace pdr
