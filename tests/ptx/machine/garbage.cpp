#include "tests/ptx/machine/garbage.h"

#include <algorithm>
#include <cstring>

namespace pdr::ptx {

/// Random bytes by xorshift (Marsaglia 2003), which is fast, from a state that differs at each call.
void Garbage::fill(void* memory, u64 bytes) {
    if (fill_ != Fill::atRandom) {
        std::memset(memory, fill_ == Fill::ones ? 0xFF : 0, bytes);
        return;
    }
    u64 state = random_() * 0x9E3779B97F4A7C15ull + 1;
    auto* to = static_cast<u8*>(memory);
    for (u64 i = 0; i < bytes; i += sizeof state) {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        std::memcpy(to + i, &state, std::min<u64>(sizeof state, bytes - i));
    }
}

}  // namespace pdr::ptx
