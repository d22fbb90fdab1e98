#pragma once
/// The interface of a GPU: memory of its own, two streams of work, and programs that many threads run. The code in this
/// folder is written for any type that is a Gpu:
///   CudaGpu  (cuda/cuda_gpu.h)      an NVIDIA GPU, through the CUDA runtime
///   HostGpu  (emulated/host_gpu.h)  the CPU's threads and memory: schedules that are compared on the CPU, and tests
///
/// A program is a value with `void operator()(std::int64_t index) const`, marked PDR_HD; it holds numbers and pointers
/// to device memory, at most 4 KB. Its threads communicate only by atomics (gpu/atomic.h). A program for a queue, where
/// one index may take long, works step by step instead, so that threads in lockstep with others can take the next index
/// as soon as they are done with one:
///   Walk                                         state of a thread
///   bool start(std::int64_t index, Walk&) const  false: it is done already
///   bool step(Walk&) const                       false: it is done
///
/// The first error is stored, and after it nothing is done any more until it is taken: the caller that completes a step
/// calls takeStatus().

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

/// Streams of work. The work in one stream is done in order; `copy` runs beside `compute`.
enum class GpuStream { compute, copy };

struct GpuMemory {
    std::size_t total = 0, free = 0;  ///< bytes
};

template <class G>
concept Gpu = requires(G gpu, const G known, void* memory, const void* host, std::size_t bytes, GpuStream stream,
                       typename G::Event event, std::int64_t count, const std::int16_t* voxels, ivec3 size,
                       std::uint64_t texture) {
    /// Effects (kernel/features.h) that programs are compiled with and without.
    { G::kSpecializedFeatures } -> std::convertible_to<std::uint32_t>;

    /// Returns how many paths are under way together: many times the number of threads, so that the ends of kernels,
    /// where lanes run empty, are short; each takes some 350 bytes, or 210 where none continues.
    { known.pathsTogether() } -> std::same_as<std::int64_t>;

    { known.name() } -> std::convertible_to<std::string>;
    { known.memory() } -> std::same_as<GpuMemory>;

    /// Allocates device memory; null after an error. release(nullptr) does nothing; release() works after an error too.
    { gpu.allocate(bytes) } -> std::same_as<void*>;
    {gpu.release(memory)};
    /// Allocates host memory for asynchronous copies.
    { gpu.allocatePinned(bytes) } -> std::same_as<void*>;
    {gpu.releasePinned(memory)};

    /// Makes a texture of a volume in host memory, x fastest, as kernel/texture.h reads it: linearly filtered, clamped,
    /// 16 bits as [-1, 1]. In the order of `compute`. 0 after an error; one of them: it is larger than the GPU's
    /// textures can be. releaseTexture(0) does nothing; else it waits for what may still read the texture.
    { gpu.makeTexture(voxels, size) } -> std::same_as<std::uint64_t>;
    {gpu.releaseTexture(texture)};

    /// Copy in stream order. If the host memory is not pinned, the host waits for the copy's end.
    {gpu.copyToDevice(memory, host, bytes, stream)};
    {gpu.copyToHost(memory, host, bytes, stream)};
    /// Sets bytes to 0.
    {gpu.clear(memory, bytes, stream)};

    /// Records a mark in a stream, a place in its order. A fresh Event counts as reached.
    {gpu.record(event, stream)};
    {gpu.wait(stream, event)};  ///< the stream waits until the event is reached
    {gpu.await(event)};         ///< the host waits for the event
    {gpu.awaitAll()};           ///< the host waits for both streams

    { gpu.takeError() } -> std::same_as<std::optional<Error>>;
    /// Also required, for any program:
    ///   launch(program, count, stream)       program(i) for all i in [0, count)
    ///   launchQueued(program, count, stream) as many threads as the GPU holds walk through all i in [0, count)
};

}  // namespace pdr
