#pragma once
/// What a GPU is to us: memory of its own, two streams of work, and programs that many threads run. The code in this
/// folder is written for any type that is a Gpu:
///   CudaGpu  (cuda/cuda_gpu.h)  a GPU of NVIDIA's, through the CUDA runtime
///   HostGpu  (cpu/host_gpu.h)   the CPU's threads and memory: schedules that are compared on the CPU, and tests
///
/// A program is a value with `void operator()(std::int64_t index) const`, marked PDR_HD; it holds numbers and pointers
/// to device memory, at most 4 KB. Its threads do not know each other; they meet only in atomics (gpu/atomic.h).
/// A program for a queue, where one index may take long, goes step by step instead, so that threads that run in step
/// with others can take the next index as soon as they are done with one:
///   Walk                                         what a thread is at
///   bool start(std::int64_t index, Walk&) const  false: it is done already
///   bool step(Walk&) const                       false: it is done
///
/// The first error is kept, and after it nothing is done any more until it is taken: whoever completes a
/// step calls takeStatus().

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

/// Work in one stream is done in order. `copy` runs beside `compute`.
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
    /// Paths that are under way together: many times what it has threads for, so that the ends of kernels, where lanes
    /// run empty, are short; each takes some 300 bytes.
    { G::kPathsTogether } -> std::convertible_to<std::int64_t>;

    { known.name() } -> std::convertible_to<std::string>;
    { known.memory() } -> std::same_as<GpuMemory>;

    /// Device memory; null after an error. release(nullptr) does nothing; release() works after an error too.
    { gpu.allocate(bytes) } -> std::same_as<void*>;
    {gpu.release(memory)};
    /// Host memory that copies can go to and from behind the host's back.
    { gpu.allocatePinned(bytes) } -> std::same_as<void*>;
    {gpu.releasePinned(memory)};

    /// A texture of a volume in host memory, x fastest, as kernel/texture.h reads it: linearly filtered, clamped, 16
    /// bits as [-1, 1]. In the order of `compute`. 0 after an error; among them: it is larger than the GPU's textures
    /// can be. releaseTexture(0) does nothing; it waits for what may still read there.
    { gpu.makeTexture(voxels, size) } -> std::same_as<std::uint64_t>;
    {gpu.releaseTexture(texture)};

    /// In stream order. Of host memory that is not pinned the host waits for the copy's end.
    {gpu.copyToDevice(memory, host, bytes, stream)};
    {gpu.copyToHost(memory, host, bytes, stream)};
    /// Bytes of 0.
    {gpu.clear(memory, bytes, stream)};

    /// A mark in a stream: a place in its order. A fresh Event counts as reached.
    {gpu.record(event, stream)};
    {gpu.wait(stream, event)};  ///< the stream goes on only when the event is reached
    {gpu.await(event)};         ///< the host waits
    {gpu.awaitAll()};           ///< the host waits for both streams

    { gpu.takeError() } -> std::same_as<std::optional<Error>>;
    /// And, for any program:
    ///   launch(program, count, stream)       program(i) for all i in [0, count)
    ///   launchQueued(program, count, stream) as many threads as the GPU holds walk through all i in [0, count)
};

}  // namespace pdr
