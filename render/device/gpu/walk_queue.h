#pragma once
/// Shares a queue of walks (gpu.h) among the threads of a GPU. The same code serves a GPU's warps and those that are
/// emulated on the CPU (emulated/lockstep_warp.h). A Warp is kWarp threads in lockstep, seen by one of them:
///   int lane() const                               its number, from 0
///   std::uint32_t ballot(bool) const               bit l: the vote of lane l; all wait for all
///   std::uint64_t broadcast(std::uint64_t) const   the word of lane 0; all wait for all
///   static int bitsIn(std::uint32_t)               number of bits that are set

#include <cstdint>

#include "render/device/gpu/atomic.h"

namespace pdr {

inline constexpr int kWarp = 32;
inline constexpr int kIdleLanes = 8;  ///< number of idle lanes at which new walks are taken

/// Runs persistent threads: a warp goes through its walks step by step. Lanes whose walks have ended wait until
/// kIdleLanes do; then they take the next indices together, neighbouring lanes neighbouring ones. `next`: the first
/// index that is not taken yet; 0 at first.
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
