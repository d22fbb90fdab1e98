#pragma once
/// How the threads of a GPU share a queue of walks (gpu.h). One text for a GPU's warps and for those that are played on
/// the CPU (emulated/lockstep_warp.h). A Warp is kWarp threads in step, seen by one of them:
///   int lane() const                               which it is, from 0
///   std::uint32_t ballot(bool) const               bit l: what lane l says; all wait for all
///   std::uint64_t broadcast(std::uint64_t) const   what lane 0 says, likewise
///   static int bitsIn(std::uint32_t)               how many are set

#include <cstdint>

#include "render/device/gpu/atomic.h"

namespace pdr {

inline constexpr int kWarp = 32;
inline constexpr int kIdleLanes = 8;  ///< so many lanes wait before new walks are taken

/// Threads that stay: a warp goes through its walks step by step. Lanes whose walks have ended wait until kIdleLanes
/// do, then they take the next indices together, neighbours by neighbours. `next`: the first that nobody has taken; 0
/// at first.
template <class Warp, class Program>
PDR_HD_INLINE void walkQueue(const Warp& warp, const Program& program, std::int64_t count, std::uint64_t& next) {
    constexpr std::uint32_t kAll = 0xFFFFFFFFu;
    typename Program::Walk walk;
    bool walking = false, more = true;
    while (true) {
        const std::uint32_t idle = warp.ballot(!walking);
        if (idle == kAll && !more)
            return;
        const int idleLanes = Warp::bitsIn(idle);
        if (idleLanes >= kIdleLanes && more) {
            const std::uint64_t taken = warp.lane() == 0 ? atomicAddTo(next, std::uint64_t(idleLanes)) : 0;
            const auto first = std::int64_t(warp.broadcast(taken));
            const std::int64_t index = first + Warp::bitsIn(idle & ((1u << warp.lane()) - 1));
            more = first < count;
            if (!walking && index < count)
                walking = program.start(index, walk);
        }
        if (walking)
            walking = program.step(walk);
    }
}

}  // namespace pdr
