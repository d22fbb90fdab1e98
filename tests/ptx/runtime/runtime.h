#pragma once
/// What the CUDA runtime holds: one of it for each program.

#include <cuda_runtime_api.h>

#include <memory>
#include <mutex>
#include <string>

#include "tests/ptx/runtime/failures.h"
#include "tests/ptx/runtime/kernels.h"
#include "tests/ptx/runtime/pinned_memory.h"
#include "tests/ptx/runtime/stream_set.h"

/// What the handles of CUDA's interface, which only names these types, point to.
struct CUstream_st {
    std::size_t number;
};
struct CUevent_st {
    std::shared_ptr<pdr::ptx::Work> work;  ///< work that stands for the event; null: never recorded
};
struct cudaArray {
    pdr::ptx::Texture texture;
    pdr::ptx::u64 memory;  ///< address in the device's memory, where it takes room
};

namespace pdr::ptx {

class Runtime {
  public:
    /// Returns the program's runtime. CUDA's interface consists of functions without an object, so there is no other
    /// way to it. It outlives whatever frees memory while the program ends.
    static Runtime& get();

    /// Runs the body of a call: counts it, lets it fail where that is wanted or the device is lost, and keeps its error
    /// for cudaGetLastError. Ends the program with code 3 at what this library does not know.
    template <class Body>
    cudaError_t call(const char* name, const Body& body) {
        const std::lock_guard lock(guard_);
        cudaError_t status = begin(name);
        if (status == cudaSuccess) {
            try {
                status = body(*this);
            } catch (const DeviceFault& fault) {
                findings.tell(fault.what());
                status = cudaError_t(fault.status);
            } catch (const NotKnown& error) {
                stop(error);
            }
        }
        return end(name, status);
    }
    /// Returns this thread's last error and forgets it; that of a lost device stays.
    cudaError_t takeLastError();
    /// Registers what nvcc's code hands over before main().
    template <class Body>
    decltype(auto) setUp(const Body& body) {
        const std::lock_guard lock(guard_);
        return body(*this);
    }
    std::size_t numberOf(cudaStream_t stream) const { return stream != nullptr ? stream->number : defaultStream_; }

    const Settings settings = settingsFromEnvironment();
    Findings findings;
    Garbage garbage{settings};
    DeviceMemory memory{settings, garbage};
    PinnedMemory pinned{garbage};
    StreamSet streams{settings, findings};
    Textures textures;
    Kernels kernels;
    u32 launches = 0;

  private:
    Runtime();

    cudaError_t begin(const char* name);
    cudaError_t end(const char* name, cudaError_t status);
    [[noreturn]] void stop(const NotKnown& error);

    std::recursive_mutex guard_;
    Failures failures_{settings.fail};
    cudaError_t lost_ = cudaSuccess;
    std::size_t defaultStream_;
};

}  // namespace pdr::ptx
