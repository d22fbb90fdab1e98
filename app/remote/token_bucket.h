#pragma once
/// Rate limit with bursts (token bucket). Has no clock: the caller passes the time.

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace pdr::remote {

struct RateLimit {
    std::int64_t perSecond = 1;  ///< [1, 1e6]; one microsecond is the finest that is told apart
    std::int64_t burst = 1;      ///< at once, after a rest of burst / perSecond; [1, 1e6]
};

class TokenBucket {
  public:
    using Moment = std::chrono::microseconds;  ///< since any moment, never back

    /// Full.
    explicit TokenBucket(const RateLimit& limit)
        : interval_(std::chrono::microseconds(1'000'000) / limit.perSecond), all_(limit.burst * interval_) {}

    /// Whether `count` more may pass. They take nothing where they may not.
    bool take(Moment now, std::int64_t count = 1) {
        const Moment full = std::max(full_, now) + count * interval_;
        if (full - now > all_)
            return false;
        full_ = full;
        return true;
    }

  private:
    Moment interval_, all_;            ///< of one token, of a full bucket: to come in
    Moment full_ = Moment::min() / 2;  ///< when the bucket is full, if nothing more is taken
};

}  // namespace pdr::remote
