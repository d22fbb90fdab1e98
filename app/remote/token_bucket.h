#pragma once
/// Rate limit with bursts (token bucket). Has no clock: the caller passes the time.

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace pdr::remote {

struct RateLimit {
    std::int64_t perSecond = 1;  ///< average rate; [1, 1e6], since the resolution is one microsecond
    std::int64_t burst = 1;      ///< number at once, after a rest of burst / perSecond seconds; [1, 1e6]
};

class TokenBucket {
  public:
    using Moment = std::chrono::microseconds;  ///< time since an arbitrary epoch, never decreasing

    /// Starts with a full bucket.
    explicit TokenBucket(const RateLimit& limit)
        : interval_(std::chrono::microseconds(1'000'000) / limit.perSecond), all_(limit.burst * interval_) {}

    /// Takes `count` tokens. Returns false and takes none if there are fewer.
    bool take(Moment now, std::int64_t count = 1) {
        const Moment full = std::max(full_, now) + count * interval_;
        if (full - now > all_)
            return false;
        full_ = full;
        return true;
    }

  private:
    Moment interval_, all_;            ///< time to gain one token, and to fill an empty bucket
    Moment full_ = Moment::min() / 2;  ///< when the bucket is full, if nothing more is taken
};

}  // namespace pdr::remote
