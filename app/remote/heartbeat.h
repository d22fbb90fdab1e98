#pragma once
/// Detects a peer that hangs, of which TCP says nothing. Has no clock: the caller passes the time, several times
/// between two Pings. Time in which this program itself was stopped does not count as silence.

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

#include "app/wire/messages.h"

namespace pdr::remote {

struct HeartbeatLimits {
    std::chrono::milliseconds interval{1000};  ///< between two Pings
    std::chrono::milliseconds suspect{3000};   ///< of silence
    std::chrono::milliseconds dead{10000};     ///< of silence
};

class Heartbeat {
  public:
    using Moment = std::chrono::microseconds;  ///< since any moment, never back
    enum class Peer { fine, suspect, dead };

    explicit Heartbeat(Moment now, const HeartbeatLimits& limits = {});

    /// Time passes. Dead is for ever.
    Peer at(Moment now);
    /// Something arrived: a message or a part of one.
    void heard(Moment now);
    /// The Ping to send, where it is time for one. The first at once. For the side that sends Pings.
    std::optional<wire::Ping> due(Moment now);
    /// An answer arrived. One to no Ping, or a second one, says nothing about latency.
    void answered(const wire::Pong& pong, Moment now);
    /// From a Ping to its Pong: the median of the last answers.
    std::optional<Moment> latency() const;

  private:
    struct Sent {
        std::uint64_t number;
        Moment when;
    };
    HeartbeatLimits limits_;
    Moment last_;        ///< when it was told the time
    Moment silence_{0};  ///< so far, but for standing still
    Peer peer_ = Peer::fine;
    std::optional<Moment> pinged_;
    std::uint64_t number_ = 0;
    std::deque<Sent> open_;
    std::deque<Moment> latencies_;
};

}  // namespace pdr::remote
