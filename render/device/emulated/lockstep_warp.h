#pragma once
/// A warp of a GPU, emulated by one thread of the CPU: kWarp threads, each on a stack of its own, run one after the
/// other, each up to its next exchange with the others. A thread that omits an exchange, or makes one alone, is
/// detected.

#include <ucontext.h>

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>

#include "render/device/gpu/walk_queue.h"

namespace pdr {

class LockstepWarp {
  public:
    /// A thread of the warp; see walk_queue.h.
    class Lane {
      public:
        int lane() const { return lane_; }
        std::uint32_t ballot(bool vote) const;
        std::uint64_t broadcast(std::uint64_t word) const;
        static int bitsIn(std::uint32_t bits) { return std::popcount(bits); }

      private:
        friend class LockstepWarp;
        Lane(LockstepWarp& warp, int lane) : warp_(warp), lane_(lane) {}
        LockstepWarp& warp_;
        int lane_;
    };

    LockstepWarp();
    LockstepWarp(const LockstepWarp&) = delete;
    LockstepWarp& operator=(const LockstepWarp&) = delete;

    /// Runs thread(lane) for all lanes to their ends. `afterMeeting` is called each time that all have met. Returns
    /// whether all have ended together, as a GPU requires.
    bool run(const std::function<void(const Lane&)>& thread, const std::function<void()>& afterMeeting);

  private:
    /// What the lanes have contributed to an exchange: since they last met (saying_), and before (said_).
    struct Said {
        std::uint32_t votes = 0;
        std::uint64_t word = 0;
    };
    struct Thread {
        ucontext_t context;
        std::unique_ptr<std::byte[]> stack;
        bool ended = false;
    };

    static void enter();
    void meet(int lane) { swapcontext(&threads_[std::size_t(lane)].context, &scheduler_); }

    ucontext_t scheduler_;
    std::array<Thread, kWarp> threads_;
    const std::function<void(const Lane&)>* thread_ = nullptr;
    int running_ = 0;
    Said saying_, said_;
};

}  // namespace pdr
