#pragma once
/// Host memory for asynchronous copies. While a copy waits, what it will write is out of the host's reach, and what it
/// will read cannot be changed.

#include <map>

#include "tests/ptx/machine/garbage.h"

namespace pdr::ptx {

class PinnedMemory {
  public:
    explicit PinnedMemory(Garbage& garbage) : garbage_(garbage) {}

    /// Returns null where the system has no memory.
    void* allocate(u64 bytes);
    /// Returns whether something was allocated there.
    bool release(void* memory);
    /// Returns the address at which the memory around `address` begins; 0: it is not pinned.
    u64 beginOf(u64 address) const;

    /// `address` is of pinned memory. A copy begins to wait, to write there or to read from there.
    void hold(u64 address, bool writes) { count(address, writes, 1); }
    /// The copy takes place.
    void open(u64 address);
    void letGo(u64 address, bool writes) { count(address, writes, -1); }
    void letAllGo();

  private:
    struct Block {
        u64 bytes;
        int readers = 0, writers = 0;  ///< copies that wait
    };
    void count(u64 address, bool writes, int more);

    Garbage& garbage_;
    std::map<u64, Block> blocks_;
};

}  // namespace pdr::ptx
