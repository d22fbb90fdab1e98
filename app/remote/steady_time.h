#pragma once
/// Monotonic time for heartbeats and backoff, which have no clock.

#include <chrono>

namespace pdr::remote {

/// Returns the time since an arbitrary epoch, which is the same for all calls; never decreases.
inline std::chrono::microseconds steadyTime() {
    using namespace std::chrono;
    return duration_cast<microseconds>(steady_clock::now().time_since_epoch());
}

}  // namespace pdr::remote
