#pragma once
/// Time that passes only where work is said to take some: what a test measures is the same on a busy machine.

#include <atomic>
#include <memory>

#include "render/session/session.h"

namespace pdr::test {

class FakeClock {
  public:
    double seconds() const { return seconds_; }
    /// Never back.
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
