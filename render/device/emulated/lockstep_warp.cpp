#include "render/device/emulated/lockstep_warp.h"

#include <algorithm>
#include <utility>

namespace pdr {

namespace {

constexpr std::size_t kStack = 256 << 10;  ///< size of a thread's stack [bytes]

thread_local LockstepWarp* starting =
    nullptr;  ///< the warp whose thread is being entered: makecontext() passes on no pointer

}  // namespace

LockstepWarp::LockstepWarp() {
    for (Thread& thread : threads_)
        thread.stack = std::make_unique_for_overwrite<std::byte[]>(kStack);
}

std::uint32_t LockstepWarp::Lane::ballot(bool vote) const {
    warp_.saying_.votes |= std::uint32_t(vote) << lane_;
    warp_.meet(lane_);
    return warp_.said_.votes;
}

std::uint64_t LockstepWarp::Lane::broadcast(std::uint64_t word) const {
    if (lane_ == 0)
        warp_.saying_.word = word;
    warp_.meet(lane_);
    return warp_.said_.word;
}

void LockstepWarp::enter() {
    LockstepWarp& warp = *starting;
    const int lane = warp.running_;
    (*warp.thread_)(Lane(warp, lane));
    warp.threads_[std::size_t(lane)].ended = true;
}

bool LockstepWarp::run(const std::function<void(const Lane&)>& thread, const std::function<void()>& afterMeeting) {
    thread_ = &thread;
    // Give each lane a stack and an entry point
    for (Thread& one : threads_) {
        one.ended = false;
        getcontext(&one.context);
        one.context.uc_stack.ss_sp = one.stack.get();
        one.context.uc_stack.ss_size = kStack;
        one.context.uc_link = &scheduler_;
        makecontext(&one.context, &LockstepWarp::enter, 0);
    }
    std::ptrdiff_t ended = 0;
    // Run all lanes to their next meeting until some have ended
    while (ended == 0) {
        for (running_ = 0; running_ < kWarp; ++running_) {
            starting = this;
            swapcontext(&scheduler_, &threads_[std::size_t(running_)].context);
        }
        said_ = std::exchange(saying_, {});
        afterMeeting();
        ended = std::ranges::count(threads_, true, &Thread::ended);
    }
    return ended == kWarp;
}

}  // namespace pdr
