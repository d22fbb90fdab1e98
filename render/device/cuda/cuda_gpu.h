#pragma once
/// An NVIDIA GPU through the CUDA runtime: a Gpu (gpu/gpu.h). For files that nvcc compiles.

#include <cuda_runtime.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/device/gpu/gpu.h"
#include "render/device/gpu/walk_queue.h"
#include "render/device/preparation.h"
#include "render/kernel/features.h"

namespace pdr {

/// Runs program(index) for all indices, one thread each.
template <class Program>
__global__ void forEachIndex(const __grid_constant__ Program program, std::int64_t count) {
    const std::int64_t index = std::int64_t(blockIdx.x) * blockDim.x + threadIdx.x;
    if (index < count)
        program(index);
}

/// A warp for walkQueue(); see gpu/walk_queue.h.
struct CudaWarp {
    static constexpr unsigned kAll = 0xFFFFFFFFu;

    __device__ int lane() const { return int(threadIdx.x % kWarp); }
    __device__ std::uint32_t ballot(bool vote) const { return __ballot_sync(kAll, vote); }
    __device__ std::uint64_t broadcast(std::uint64_t word) const {
        return __shfl_sync(kAll, static_cast<unsigned long long>(word), 0);
    }
    static __device__ int bitsIn(std::uint32_t bits) { return __popc(bits); }
};

template <class Program>
__global__ void walkQueued(const __grid_constant__ Program program, std::int64_t count, std::uint64_t* next) {
    walkQueue(CudaWarp(), program, count, *next);
}

/// Returns the kernels that launch() and launchQueued() run.
template <class... Programs>
std::vector<const void*> kernelsOf() {
    return {reinterpret_cast<const void*>(forEachIndex<Programs>)...};
}
template <class... Programs>
std::vector<const void*> queuedKernelsOf() {
    return {reinterpret_cast<const void*>(walkQueued<Programs>)...};
}

class CudaGpu {
  public:
    /// A mark in a stream; made when it is first recorded.
    class Event {
      public:
        Event() = default;
        ~Event();
        Event(const Event&) = delete;
        Event& operator=(const Event&) = delete;

      private:
        friend class CudaGpu;
        cudaEvent_t event_ = nullptr;
    };

    static constexpr std::uint32_t kSpecializedFeatures = kFeatureMasks - 1;

    /// Opens GPU number `index`, from 0. `name`: as errors call it. `preparing`: see prepare(); empty: the program has
    /// machine code for this GPU, or nobody waits.
    CudaGpu(int index, std::string name, PreparationObserver preparing = {});
    ~CudaGpu();
    CudaGpu(const CudaGpu&) = delete;
    CudaGpu& operator=(const CudaGpu&) = delete;

    const std::string& name() const { return name_; }
    std::int64_t pathsTogether() const { return pathsTogether_; }
    GpuMemory memory() const;

    void* allocate(std::size_t bytes);
    void release(void* memory);
    void* allocatePinned(std::size_t bytes);
    void releasePinned(void* memory);
    std::uint64_t makeTexture(const std::int16_t* voxels, ivec3 size);
    void releaseTexture(std::uint64_t texture);
    void copyToDevice(void* to, const void* from, std::size_t bytes, GpuStream stream);
    void copyToHost(void* to, const void* from, std::size_t bytes, GpuStream stream);
    void clear(void* memory, std::size_t bytes, GpuStream stream);

    void record(Event& event, GpuStream stream);
    void wait(GpuStream stream, Event& event);
    void await(Event& event);
    void awaitAll();
    std::optional<Error> takeError();

    /// Lets the driver translate those of `kernels` that it has not seen yet, and tells the observer before and after.
    /// Without an observer they are translated at their first launch.
    void prepare(const std::vector<const void*>& kernels);

    template <class Program>
    void launch(const Program& program, std::int64_t count, GpuStream stream) {
        if (!ready() || count <= 0)
            return;
        start(forEachIndex<Program>, blocksFor(count), stream, program, count);
    }

    template <class Program>
    void launchQueued(const Program& program, std::int64_t count, GpuStream stream) {
        if (!ready() || count <= 0)
            return;
        const void* kernel = reinterpret_cast<const void*>(walkQueued<Program>);
        const unsigned blocks = std::min(blocksFor(count), residentBlocks(kernel));
        if (blocks > 0 && check(cudaMemsetAsync(next_, 0, sizeof *next_, of(stream)), "a launch"))
            start(walkQueued<Program>, blocks, stream, program, count, next_);
    }

  private:
    static constexpr int kThreads = 128;
    static constexpr std::int64_t kFewestPaths = 1 << 20;

    /// Returns the number of blocks that have a thread for each index.
    static unsigned blocksFor(std::int64_t count) { return unsigned((count + kThreads - 1) / kThreads); }
    /// Launches a kernel with `arguments`. The code that nvcc makes of <<<>>> asks for each kernel once in a process,
    /// and cannot launch it any more if that fails once; this function of the runtime asks each time.
    template <class... Arguments>
    void start(void (*kernel)(Arguments...), unsigned blocks, GpuStream stream, Arguments... arguments) {
        void* places[] = {&arguments...};
        check(cudaLaunchKernel(reinterpret_cast<const void*>(kernel), blocks, kThreads, places, 0, of(stream)),
              "a launch");
    }
    /// Returns whether calls may be made: no error is stored. This thread's calls then go to this GPU.
    bool ready();
    /// Stores the first error and returns whether there was none; `doing`: what was tried, "a launch".
    bool check(cudaError_t status, const char* doing);
    /// Returns whether textures may be that large; if not, stores the error.
    bool textureFits(ivec3 size);
    /// Returns a texture object for `array`; 0 after an error.
    cudaTextureObject_t textureOf(cudaArray_t array);
    cudaStream_t of(GpuStream stream) const { return streams_[int(stream)]; }
    /// Sets pathsTogether_ to 32 for each thread that the GPU holds, within a sixteenth of its memory; kFewestPaths
    /// where it does not say.
    void choosePathsTogether();
    /// Returns how many blocks of a kernel the GPU holds at a time; 0: an error is stored.
    unsigned residentBlocks(const void* kernel);

    int index_;
    std::string name_;
    std::array<cudaStream_t, 2> streams_{};
    std::uint64_t* next_ = nullptr;  ///< next index of the queue
    std::int64_t pathsTogether_ = kFewestPaths;
    std::map<const void*, unsigned> residentBlocks_;
    PreparationObserver preparing_;
    std::set<const void*> prepared_;
    std::optional<Error> error_;
};

static_assert(Gpu<CudaGpu>);

}  // namespace pdr
