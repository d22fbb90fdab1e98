#pragma once
/// The time for heartbeats and backoff, which know no clock.

#include <chrono>

namespace pdr::remote {

/// Since some moment, the same for all calls; never goes back.
inline std::chrono::microseconds steadyTime() {
    using namespace std::chrono;
    return duration_cast<microseconds>(steady_clock::now().time_since_epoch());
}

}  // namespace pdr::remote
