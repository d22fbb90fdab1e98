#pragma once
/// The ledger of the scene that is being rendered, filled between launches and only while somebody looks.

#include <memory>
#include <optional>
#include <stop_token>

#include "render/session/effect_ledger.h"
#include "render/session/session.h"

namespace pdr {

class LiveLedger {
  public:
    explicit LiveLedger(SessionClock clock) : clock_(std::move(clock)) {}

    /// Somebody looks from now on, or nobody: then nothing is measured, and what was is forgotten.
    void watch(EffectsWatch watch);
    /// What is in hand now. What is known of the same scene, seen otherwise, stays as that of the view before.
    void follow(const Scene& scene, const Display& display);
    /// There is no scene.
    void forget();

    /// Whether something is still to be measured.
    bool hasWork() const;
    /// Whether measuring has had less than its part of the time.
    bool isDue() const { return spent_ <= kPart * (clock_() - begunAt_); }
    /// One launch; it has work. After a stop request nothing of it is kept.
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
    std::unique_ptr<Calibration> calibration_;  ///< after both: it must not outlive them
    EffectLedger ledger_;                       ///< as it was told last
    double begunAt_ = 0, spent_ = 0;            ///< of the scene in hand [s]
};

}  // namespace pdr
