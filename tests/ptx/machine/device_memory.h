#pragma once
/// The memory of the device. Its addresses mean nothing to the host, whose access to one is a bad address. An address
/// is never given twice, so that what was freed stays known.

#include <string>
#include <unordered_map>
#include <vector>

#include "tests/ptx/machine/byte_watch.h"
#include "tests/ptx/machine/garbage.h"
#include "tests/ptx/machine/pages.h"

namespace pdr::ptx {

class DeviceMemory {
  public:
    DeviceMemory(const Settings& settings, Garbage& garbage);

    /// Returns an address that 256 divides and no larger power of two, so that nothing relies on more; 0: there is too
    /// little memory left. Throws NotKnown once all addresses are used up.
    u64 allocate(u64 bytes);
    /// Returns whether something was allocated there.
    bool release(u64 address);
    u64 freeBytes() const { return total_ - used_; }
    u64 totalBytes() const { return total_; }

    /// Returns whether an address is the device's, allocated or not.
    bool isDevice(u64 address) const { return address - base_ < room_; }
    /// Returns where the bytes lie for this library; null where not all are in one allocation.
    u8* at(u64 address, u64 bytes) const {
        const u64 relative = address - base_;
        if (relative >= room_)
            return nullptr;
        const Allocation& one = all_[pages_[relative / kPage]];
        const bool isInside = relative >= one.low && relative + bytes <= one.high;
        return isInside ? storage_ + relative : nullptr;
    }
    /// Returns the number of the allocation at an address, from 1; 0: nothing is allocated there.
    u32 numberAt(u64 address) const { return pages_[(address - base_) / kPage]; }
    /// Returns what lies near [address, address + bytes), for a sentence.
    std::string describe(u64 address, u64 bytes) const;

    void markWritten(u64 address, u64 bytes) { watch_.markWritten(address - base_, bytes); }
    bool watches() const { return watch_.isOn(); }
    /// See ByteWatch::access(); the bytes must be allocated.
    const char* watch(u64 address, u32 bytes, Access access, Accessor who) {
        return watch_.access(address - base_, bytes, access, who);
    }

  private:
    struct Allocation {
        u64 low = 1, high = 0;  ///< from base_; nothing: there is none
        bool isFreed = false;
        u64 distanceTo(u64 relative) const;
    };

    Garbage& garbage_;
    u64 total_, used_ = 0;
    u64 room_;          ///< bytes of addresses
    u64 next_ = kPage;  ///< the first that was never given
    u64 base_;
    u8* storage_;
    u32* pages_;  ///< number of the allocation on each page
    ByteWatch watch_;
    std::vector<Allocation> all_{1};
    std::unordered_map<u64, u32> byAddress_;
};

}  // namespace pdr::ptx
