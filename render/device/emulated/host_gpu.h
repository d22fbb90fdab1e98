#pragma once
/// A Gpu (gpu/gpu.h) made of the CPU's threads and memory: code for GPUs runs on the CPU too, for comparison and for
/// tests without a GPU. Every call is carried out before it returns, so both streams are in order and every event is
/// reached. The walks of a queue run one by one to their ends, or in warps as on a GPU.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "render/base/result.h"
#include "render/device/emulated/lockstep_warp.h"
#include "render/device/emulated/warp_counts.h"
#include "render/device/gpu/gpu.h"

namespace pdr {

class HostGpu {
  public:
    struct Event {};

    /// Effects that programs are specialized for: none. One program has all effects, since it need not be fast.
    static constexpr std::uint32_t kSpecializedFeatures = 0;
    /// Largest size of a program [bytes]: it is sent to a GPU by value.
    static constexpr std::size_t kLargestProgram = 4096;

    enum class Walks { oneByOne, inWarps };

    /// Makes a GPU with `totalBytes` of memory, 0 = all that the machine has; `threads` 0 = one per core.
    explicit HostGpu(std::size_t totalBytes = 0, int threads = 0, Walks walks = Walks::oneByOne);
    ~HostGpu();
    HostGpu(const HostGpu&) = delete;
    HostGpu& operator=(const HostGpu&) = delete;

    /// Returns how many paths are under way together: few, so that the images of tests take many turns.
    std::int64_t pathsTogether() const { return 1'000; }

    std::string name() const { return "cpu"; }
    GpuMemory memory() const;

    /// Allocates memory at addresses that 256 divides. Errors: more than memory().free.
    void* allocate(std::size_t bytes);
    void release(void* memory);
    /// Allocates host memory, which does not count as the device's.
    void* allocatePinned(std::size_t bytes);
    void releasePinned(void* memory);

    /// Allocates only the bytes of a texture: the kernel computes from the volume itself what a texture unit would.
    std::uint64_t makeTexture(const std::int16_t* voxels, ivec3 size);
    void releaseTexture(std::uint64_t texture) { release(reinterpret_cast<void*>(texture)); }

    void copyToDevice(void* to, const void* from, std::size_t bytes, GpuStream stream);
    void copyToHost(void* to, const void* from, std::size_t bytes, GpuStream stream);
    void clear(void* memory, std::size_t bytes, GpuStream stream);

    template <class Program>
    void launch(Program program, std::int64_t count, GpuStream) {
        run<Program>(program, count, Order::even);
    }
    template <class Program>
    void launchQueued(Program program, std::int64_t count, GpuStream) {
        if (walks_ == Walks::inWarps)
            return launchWarps(program, count);
        const auto walk = [&program](std::int64_t index) {
            typename Program::Walk at{};
            for (bool going = program.start(index, at); going;)
                going = program.step(at);
        };
        run<Program>(walk, count, Order::queued);
    }

    void record(Event&, GpuStream) {}
    void wait(GpuStream, Event&) {}
    void await(Event&) {}
    void awaitAll() {}

    std::optional<Error> takeError();

    /// Returns what the warps of each queue have done so far, by the queue's name (kName); empty if there are no warps.
    const std::map<std::string, WarpCounts>& warpCounts() const { return warpCounts_; }

    /// Returns the bytes that are allocated and not yet released, pinned ones included.
    std::size_t allocated() const;

  protected:
    /// Stores the first error.
    void fail(Error error);
    bool failed() const;

  private:
    enum class Order { even, queued };
    struct Threads;

    template <class Program, class Each>
    void run(const Each& each, std::int64_t count, Order order) {
        static_assert(std::is_trivially_copyable_v<Program> && sizeof(Program) <= kLargestProgram);
        if (failed() || count <= 0)
            return;
        distribute(count, order, [&each](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i != end; ++i)
                each(i);
        });
    }

    /// Runs a queue as a GPU does, with the code that runs there. Several warps share the queue.
    template <class Program>
    void launchWarps(const Program& program, std::int64_t count) {
        constexpr std::int64_t kWarps = 3;
        std::uint64_t next = 0;
        run<Program>([&](std::int64_t) { walkInWarp(program, count, next); }, count > 0 ? kWarps : 0, Order::queued);
    }

    template <class Program>
    void walkInWarp(const Program& program, std::int64_t count, std::uint64_t& next) {
        WarpCounts counts;
        WalkCounts since;
        const CountedWalks<Program> counted{program, since};
        const bool together =
            LockstepWarp().run([&](const LockstepWarp::Lane& lane) { walkQueue(lane, counted, count, next); },
                               [&] { counts.add(std::exchange(since, {})); });
        if (!together)
            fail({phrase("the threads of a warp have lost each other"), name(), "This is a bug in the program.",
                  ErrorKind::deviceLost});
        const std::lock_guard lock(mutex_);
        if constexpr (requires { Program::kName; })
            warpCounts_[Program::kName].add(counts);
    }

    /// Calls piece(begin, end) from all threads so that [0, count) is covered.
    void distribute(std::int64_t count, Order order, const std::function<void(std::int64_t, std::int64_t)>& piece);

    /// Returns new memory, or null if the machine has none left.
    void* taken(std::size_t bytes);
    /// Releases memory and returns its size [bytes].
    std::size_t given(void* memory);

    std::size_t total_;
    std::unique_ptr<Threads> threads_;
    Walks walks_;

    mutable std::mutex mutex_;                          ///< protects the rest
    std::unordered_map<void*, std::size_t> allocated_;  ///< bytes by address, pinned ones included
    std::size_t used_ = 0, pinned_ = 0;                 ///< bytes
    std::map<std::string, WarpCounts> warpCounts_;
    std::optional<Error> error_;
};

static_assert(Gpu<HostGpu>);

}  // namespace pdr
