#pragma once
/// A GPU emulated on the CPU whose calls fail when a test says so.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "render/device/emulated/host_gpu.h"

namespace pdr::test {

/// The call that is to fail, and what was called. The test shares it with the FaultyGpu.
struct FaultPlan {
    enum class Call { any, allocate, pinned, texture, copy, clear, launch, event, await };
    static constexpr int kNever = -1;

    Call call = Call::any;  ///< kind of the call that fails
    int fails = kNever;     ///< index of the call of that kind that fails, from 0
    bool lost = false;      ///< after the failure every call fails: the device is gone
    int calls = 0;          ///< number of calls of that kind so far
    bool failed = false;    ///< the failure has happened

    std::int64_t longestQueue = 0;  ///< most indices of a queued launch so far
};

/// Fails as its plan says. Errors: "it failed on purpose", where "faulty".
class FaultyGpu : public HostGpu {
  public:
    explicit FaultyGpu(std::shared_ptr<FaultPlan> plan = std::make_shared<FaultPlan>(), std::size_t totalBytes = 0,
                       int threads = 0)
        : HostGpu(totalBytes, threads), plan_(std::move(plan)) {}

    std::string name() const { return "faulty"; }

    /// Returns the GPU's memory; nothing once the device is lost.
    GpuMemory memory() const { return plan_->lost && plan_->failed ? GpuMemory{} : HostGpu::memory(); }

    void* allocate(std::size_t bytes) {
        count(FaultPlan::Call::allocate);
        return HostGpu::allocate(bytes);
    }
    void* allocatePinned(std::size_t bytes) {
        count(FaultPlan::Call::pinned);
        return HostGpu::allocatePinned(bytes);
    }
    std::uint64_t makeTexture(const std::int16_t* voxels, ivec3 size) {
        count(FaultPlan::Call::texture);
        return HostGpu::makeTexture(voxels, size);
    }
    void copyToDevice(void* to, const void* from, std::size_t bytes, GpuStream stream) {
        count(FaultPlan::Call::copy);
        HostGpu::copyToDevice(to, from, bytes, stream);
    }
    void copyToHost(void* to, const void* from, std::size_t bytes, GpuStream stream) {
        count(FaultPlan::Call::copy);
        HostGpu::copyToHost(to, from, bytes, stream);
    }
    void clear(void* memory, std::size_t bytes, GpuStream stream) {
        count(FaultPlan::Call::clear);
        HostGpu::clear(memory, bytes, stream);
    }
    template <class Program>
    void launch(Program program, std::int64_t indices, GpuStream stream) {
        count(FaultPlan::Call::launch);
        HostGpu::launch(program, indices, stream);
    }
    template <class Program>
    void launchQueued(Program program, std::int64_t indices, GpuStream stream) {
        count(FaultPlan::Call::launch);
        plan_->longestQueue = std::max(plan_->longestQueue, indices);
        HostGpu::launchQueued(program, indices, stream);
    }
    void record(Event& event, GpuStream stream) {
        count(FaultPlan::Call::event);
        HostGpu::record(event, stream);
    }
    void wait(GpuStream stream, Event& event) {
        count(FaultPlan::Call::event);
        HostGpu::wait(stream, event);
    }
    void await(Event& event) {
        count(FaultPlan::Call::await);
        HostGpu::await(event);
    }
    void awaitAll() {
        count(FaultPlan::Call::await);
        HostGpu::awaitAll();
    }

  private:
    void count(FaultPlan::Call call) {
        const bool gone = plan_->lost && plan_->failed;
        const bool counts = plan_->call == FaultPlan::Call::any || plan_->call == call;
        const bool now = counts && plan_->calls++ == plan_->fails;
        plan_->failed = plan_->failed || now;
        if (now || gone)
            fail({"it failed on purpose", name(), "Try again.", ErrorKind::deviceLost});
    }

    std::shared_ptr<FaultPlan> plan_;
};

static_assert(Gpu<FaultyGpu>);

}  // namespace pdr::test
