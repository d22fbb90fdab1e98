#pragma once
/// A clock that advances only when a test says that work takes time, so that measurements are the same on a busy
/// machine.

#include <atomic>
#include <memory>

#include "render/session/session.h"

namespace pdr::test {

class FakeClock {
  public:
    double seconds() const { return seconds_; }
    /// Advances to that time, never back.
    void advanceTo(double seconds) {
        double now = seconds_;
        while (now < seconds && !seconds_.compare_exchange_weak(now, seconds)) {
        }
    }

  private:
    std::atomic<double> seconds_ = 1;
};

inline SessionClock readingOf(const std::shared_ptr<FakeClock>& clock) {
    return [clock] { return clock->seconds(); };
}

}  // namespace pdr::test
