#pragma once
/// Decides how long to wait before dialling again, and when to give up. Has no clock and no random numbers: the caller
/// passes both.

#include <algorithm>
#include <chrono>
#include <optional>

namespace pdr::remote {

struct BackoffLimits {
    std::chrono::milliseconds first{200}, longest{10000};
    std::chrono::milliseconds giveUp{120000};  ///< time after the first failure in a row
};

class Backoff {
  public:
    explicit Backoff(const BackoffLimits& limits = {}) : limits_(limits) {}

    /// Records a failure at `now` (time since an arbitrary epoch, never decreasing). Returns how long to wait: at least
    /// half of 0.2 s, 0.4 s, ... 10 s and at most all of it. `random` in [0, 1) chooses, so that nodes that failed
    /// together do not dial together. Nothing: give up, since the next attempt would come too late.
    std::optional<std::chrono::milliseconds> failed(std::chrono::microseconds now, double random) {
        if (!failing_)
            since_ = now;
        failing_ = true;
        const auto wait = std::chrono::milliseconds(std::int64_t(next_.count() * (0.5 + 0.5 * random)));
        if (now + wait - since_ > limits_.giveUp)
            return std::nullopt;
        next_ = std::min(2 * next_, limits_.longest);
        return wait;
    }
    /// Records a success: the next failure counts as the first one.
    void succeeded() { *this = Backoff(limits_); }

  private:
    BackoffLimits limits_;
    std::chrono::milliseconds next_ = limits_.first;
    bool failing_ = false;
    std::chrono::microseconds since_{0};  ///< time of the first failure in a row
};

}  // namespace pdr::remote
