#pragma once
/// Cost table of the scene that is being rendered, filled between launches and only while there is an observer.

#include <memory>
#include <optional>
#include <stop_token>

#include "render/session/effect_costs.h"
#include "render/session/session.h"

namespace pdr {

class LiveEffectCosts {
  public:
    explicit LiveEffectCosts(SessionClock clock) : clock_(std::move(clock)) {}

    /// Sets the observer, and forgets all measurements. An empty one: nobody observes, and nothing is measured.
    void watch(EffectsWatch watch);
    /// Sets the current scene and display. If only the view of the scene differs from before, its results stay, marked
    /// as those of an earlier view.
    void follow(const Scene& scene, const Display& display);
    /// Forgets the scene; there is none from now on.
    void forget();

    /// Returns whether something is still to be measured.
    bool hasWork() const;
    /// Returns whether measuring has had less than its share of the time.
    bool isDue() const { return spent_ <= kPart * (clock_() - begunAt_); }
    /// Runs one launch; hasWork() must be true. After a stop request nothing of it is kept.
    void step(const std::stop_token& stop);

  private:
    static constexpr double kPart = 0.05;

    Result<void> measure(const std::stop_token& stop);
    Result<void> openDevices();
    void takeRows();
    void tell() const;

    SessionClock clock_;
    EffectsWatch watch_;
    std::optional<Scene> scene_;
    Display display_;
    std::unique_ptr<Device> with_, without_;
    std::unique_ptr<Calibration> calibration_;  ///< declared after both devices, which must outlive it
    EffectCosts effectCosts_;                   ///< as last reported
    double begunAt_ = 0, spent_ = 0;            ///< start of the current scene, and time measuring it [s]
};

}  // namespace pdr
