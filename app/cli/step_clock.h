#pragma once
/// A clock for steps that follow each other.

#include <chrono>
#include <ctime>

namespace pdr::app {

/// The time that a step took [s].
struct StepTime {
    double passed = 0;     ///< on the wall
    double processor = 0;  ///< time of all threads of the process; other programs lengthen it little
};

class StepClock {
  public:
    /// Returns the time since the last call, or since the clock was made.
    StepTime lap() {
        const auto now = std::chrono::steady_clock::now();
        const std::clock_t used = std::clock();
        const StepTime time{std::chrono::duration<double>(now - last_).count(),
                            double(used - lastUsed_) / double(CLOCKS_PER_SEC)};
        last_ = now;
        lastUsed_ = used;
        return time;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::clock_t lastUsed_ = std::clock();
};

}  // namespace pdr::app
