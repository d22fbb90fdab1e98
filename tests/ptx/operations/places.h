#pragma once
/// Where an instruction's bytes lie, after all checks of the address.

#include "tests/ptx/machine/warp.h"

namespace pdr::ptx {

inline constexpr int kIllegalAddress = 700, kMisalignedAddress = 716;  ///< values of cudaError_t
inline constexpr u64 kLocalWindow = u64(1) << 60;                      ///< generic addresses of local memory

template <class Each>
void forLanes(const Warp& w, const Each& each) {
    for (u32 rest = w.mask; rest != 0; rest &= rest - 1)
        each(__builtin_ctz(rest));
}

inline u64 addressOf(Warp& w, const Instruction& i, int lane) {
    return (i.from[0] == kNone ? 0 : w.at<u64>(i.from[0])[lane]) + u64(i.offset);
}

/// Both throw DeviceFault where there is no such place, or it is not aligned.
u8* globalPlace(Warp& w, const Instruction& i, int lane, u64 address, Access access);
u8* localPlace(Warp& w, const Instruction& i, int lane, u64 address);

}  // namespace pdr::ptx
