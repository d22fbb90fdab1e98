#pragma once
/// The measured bias of the current film's images, if they are made in a biased way. It is measured round by round, in
/// a small fraction of the time.

#include <cstdint>
#include <optional>
#include <stop_token>

#include "render/base/result.h"
#include "render/session/bias_measurements.h"
#include "render/session/film_on_device.h"
#include "render/session/session.h"

namespace pdr {

class BiasTracker {
  public:
    explicit BiasTracker(SessionClock clock) : clock_(std::move(clock)) {}

    /// Forgets all measurements, for another film. The time spent on them still counts: a scene that changes often is
    /// not measured more often.
    void clear();

    /// Returns whether measuring has had less than its fraction of the time.
    bool isDue() const;
    /// Measures one round of what is not known well enough of `scene`, the scene of `place`, whose film has so many
    /// samples in each pixel and is shown with `tone`. After a stop request the round does not count. Errors: the
    /// device's.
    Result<void> measure(FilmOnDevice& place, const Scene& scene, std::uint64_t samples, const Tone& tone,
                         const std::stop_token& stop);
    /// Returns the biases measured so far, on a display of that tone.
    MeasuredBiases known(const Tone& tone);

  private:
    static constexpr double kShare = 0.02;  ///< largest fraction of the time, after the first round

    SessionClock clock_;
    std::optional<BiasMeasurements> measurements_;  ///< none before the film's first round
    double measuredAt_ = 0;                         ///< clock time at the end of the last round
    double seconds_ = 0;                            ///< duration of that round
    MeasuredBiases known_;                          ///< biases on a display of tone_
    std::optional<Tone> tone_;                      ///< none: known_ is outdated
};

}  // namespace pdr
