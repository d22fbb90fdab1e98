#pragma once
/// How threads access memory, and what a launch has touched.

#include <algorithm>
#include <unordered_map>

#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

/// relaxedRead: a volatile load, which may meet atomics.
enum class Access : u8 { read, write, relaxedRead, atomic };

constexpr bool isWrite(Access access) {
    return access == Access::write || access == Access::atomic;
}

struct Accessor {
    u32 launch;  ///< from 1
    u32 thread;  ///< number in the launch, from 0
};

/// Addresses [low, high); none while high is 0.
struct Extent {
    u64 low = ~0ull, high = 0;

    void add(u64 address, u64 bytes) {
        low = std::min(low, address);
        high = std::max(high, address + bytes);
    }
};

/// What a launch has read and written, by the number of the allocation.
class TouchedMemory {
  public:
    struct Extents {
        Extent read, written;
    };
    void add(u32 allocation, u64 address, u64 bytes, bool writes) {
        Extents& extents = all_[allocation];
        (writes ? extents.written : extents.read).add(address, bytes);
    }
    const std::unordered_map<u32, Extents>& all() const { return all_; }

  private:
    std::unordered_map<u32, Extents> all_;
};

}  // namespace pdr::ptx
