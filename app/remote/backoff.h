#pragma once
/// How long to wait before dialling again, and when to give up. Knows no clock and draws no random numbers.

#include <algorithm>
#include <chrono>
#include <optional>

namespace pdr::remote {

struct BackoffLimits {
    std::chrono::milliseconds first{200}, longest{10000};
    std::chrono::milliseconds giveUp{120000};  ///< after the first failure in a row
};

class Backoff {
  public:
    explicit Backoff(const BackoffLimits& limits = {}) : limits_(limits) {}

    /// It failed at `now` (since any moment, never back). How long to wait: at least half of 0.2 s, 0.4 s, ... 10 s,
    /// and at most all of it, as `random` in [0, 1) says, so that nodes that failed together do not dial together.
    /// Nothing: give up, since the next try would come too late.
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
    /// The next failure is the first again.
    void succeeded() { *this = Backoff(limits_); }

  private:
    BackoffLimits limits_;
    std::chrono::milliseconds next_ = limits_.first;
    bool failing_ = false;
    std::chrono::microseconds since_{0};  ///< when the first in a row failed
};

}  // namespace pdr::remote
