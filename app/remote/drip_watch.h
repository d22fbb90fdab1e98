#pragma once
/// Detects peers that send a message so slowly that they only occupy the connection (Slowloris). A message that arrives
/// within the window is never too slow, nor is an idle connection. Has no clock: the caller passes the time.

#include <chrono>
#include <cstdint>

namespace pdr::remote {

struct DripLimits {
    std::chrono::milliseconds window{10000};
    std::int64_t bytesPerSecond = 64 << 10;  ///< of a message in flight, on average over the window
};

class DripWatch {
  public:
    explicit DripWatch(const DripLimits& limits) : limits_(limits) {}

    /// Whether the message in flight is too slow. `now`: since any moment, never back; `received`: bytes so far, of all
    /// messages; `messages`: whole ones so far; `inMessage`: a part of the next is here.
    bool tooSlow(std::chrono::milliseconds now, std::int64_t received, std::int64_t messages, bool inMessage);

  private:
    DripLimits limits_;
    bool watching_ = false;
    std::chrono::milliseconds since_{0};  ///< begin of the window ...
    std::int64_t receivedThen_ = 0;       ///< ... and what had been received then
    std::int64_t messagesThen_ = 0;
};

}  // namespace pdr::remote
