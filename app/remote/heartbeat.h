#pragma once
/// Detects a peer that hangs, which TCP does not report. Has no clock: the caller passes the time, several times
/// between two Pings. Time in which this program itself was stopped does not count as silence.

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "app/wire/messages.h"

namespace pdr::remote {

struct HeartbeatLimits {
    std::chrono::milliseconds interval{1000};  ///< time between two Pings
    std::chrono::milliseconds suspect{3000};   ///< silence after which the peer is suspect
    std::chrono::milliseconds dead{10000};     ///< silence after which the peer is dead
};

class Heartbeat {
  public:
    using Moment = std::chrono::microseconds;  ///< time since an arbitrary epoch, never decreasing
    enum class Peer { fine, suspect, dead };

    explicit Heartbeat(Moment now, const HeartbeatLimits& limits = {});

    /// Advances the time and returns the state of the peer. A dead peer stays dead.
    Peer at(Moment now);
    /// Records that a message, or a part of one, has arrived.
    void heard(Moment now);
    /// Returns the Ping to send, if one is due; the first one at once. For the side that sends Pings.
    std::optional<wire::Ping> due(Moment now);
    /// Records an answer. One to no Ping, or a second one to the same Ping, does not count for the latency.
    void answered(const wire::Pong& pong, Moment now);
    /// Returns the time from a Ping to its Pong: the median of the last answers; none: there is no answer yet.
    std::optional<Moment> latency() const;

  private:
    struct Sent {
        std::uint64_t number;
        Moment when;
    };
    HeartbeatLimits limits_;
    Moment last_;        ///< time of the last call of at()
    Moment silence_{0};  ///< silence so far, without time in which this program was stopped
    Peer peer_ = Peer::fine;
    std::optional<Moment> pinged_;
    std::uint64_t number_ = 0;
    std::deque<Sent> open_;
    std::deque<Moment> latencies_;
};

}  // namespace pdr::remote
