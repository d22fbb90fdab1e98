#pragma once
/// Detects peers that send a message so slowly that they only occupy the connection (Slowloris). A message that arrives
/// within the window is never too slow, nor is an idle connection. Has no clock: the caller passes the time.

#include <chrono>
#include <cstdint>

namespace pdr::remote {

struct DripLimits {
    std::chrono::milliseconds window{10000};
    std::int64_t bytesPerSecond = 64 << 10;  ///< minimum speed of a message in flight, averaged over the window
};

class DripWatch {
  public:
    explicit DripWatch(const DripLimits& limits) : limits_(limits) {}

    /// Returns whether the message in flight is too slow. `now`: time since an arbitrary epoch, never decreasing;
    /// `received`: bytes of all messages so far; `messages`: number of complete messages so far; `inMessage`: a part of
    /// the next message has arrived.
    bool tooSlow(std::chrono::milliseconds now, std::int64_t received, std::int64_t messages, bool inMessage);

  private:
    DripLimits limits_;
    bool watching_ = false;
    std::chrono::milliseconds since_{0};  ///< start of the window
    std::int64_t receivedThen_ = 0;       ///< bytes received at the start of the window
    std::int64_t messagesThen_ = 0;       ///< complete messages at the start of the window
};

}  // namespace pdr::remote
