#pragma once
/// A copy of the film, taken now and then, from which rendering continues if the device is lost.

#include <memory>

#include "render/base/result.h"
#include "render/session/session.h"

namespace pdr {

class Accumulator;

class Checkpoint {
  public:
    explicit Checkpoint(SessionClock clock) : clock_(std::move(clock)) {}

    /// Starts with another film, which holds the samples of `film`; null: it is empty.
    void reset(std::shared_ptr<const Film> film);
    /// Returns the last copy; null if there is none.
    const std::shared_ptr<const Film>& film() const { return film_; }

    /// Returns whether the last copy is old enough for the next one: at least kSeconds, and so old that copies take at
    /// most the fraction kShare of the time.
    bool isDue() const;
    /// Copies the film from its device. Errors: the device's; the last copy stays then.
    Result<void> take(Accumulator& film);

  private:
    static constexpr double kSeconds = 2, kShare = 0.01;

    SessionClock clock_;
    std::shared_ptr<const Film> film_;
    double takenAt_ = 0;  ///< clock time of the last copy or reset
    double seconds_ = 0;  ///< time that the last copy took
};

}  // namespace pdr
