/// CUDA's functions that register and launch kernels. nvcc's code calls those that begin with two underscores.

#include <cstdio>
#include <cstring>
#include <vector>

#include "tests/ptx/runtime/runtime.h"

#undef __cudaPushCallConfiguration

using namespace pdr::ptx;

namespace {

/// What stands between <<< and >>>.
struct Configuration {
    dim3 grid, block;
    std::size_t sharedBytes;
    cudaStream_t stream;
};
/// nvcc's code hands configurations over in two calls of one thread.
thread_local std::vector<Configuration> configurations;

constexpr u64 kMostThreads = 1024, kRegisters = 65536, kSharedBytes = 48 << 10, kMostInX = 0x7FFFFFFF,
              kMostInYZ = 65535;

bool isPossible(const dim3& grid, const dim3& block) {
    const u64 threads = u64(block.x) * block.y * block.z;
    return grid.x > 0 && grid.y > 0 && grid.z > 0 && grid.x <= kMostInX && grid.y <= kMostInYZ && grid.z <= kMostInYZ &&
           threads > 0 && threads <= kMostThreads;
}

/// Copies the arguments to where the kernel looks for them, in numbers of 8 bytes, so that they are aligned.
std::vector<u64> parametersOf(const KernelText& kernel, void** arguments) {
    std::vector<u64> parameters((kernel.parameterBytes + 7) / 8);
    auto* bytes = reinterpret_cast<u8*>(parameters.data());
    for (std::size_t n = 0; n < kernel.parameters.size(); ++n)
        std::memcpy(bytes + kernel.parameters[n].offset, arguments[n], kernel.parameters[n].bytes);
    return parameters;
}

void tellTouched(StreamSet& streams, const Work& work, const Launch& launch) {
    for (const auto& [allocation, extents] : launch.touched.all()) {
        if (extents.read.high > 0)
            streams.touches(work, allocation, extents.read, false);
        if (extents.written.high > 0)
            streams.touches(work, allocation, extents.written, true);
    }
}

cudaError_t launch(Runtime& r, const void* host, const Configuration& how, void** arguments) {
    Kernel* kernel = r.kernels.find(host);
    if (kernel == nullptr)
        return cudaErrorInvalidDeviceFunction;
    if (!kernel->runsOn(r.settings.capability))
        return cudaErrorNoKernelImageForDevice;
    if (!isPossible(how.grid, how.block))
        return cudaErrorInvalidConfiguration;
    const Size3 grid{how.grid.x, how.grid.y, how.grid.z}, block{how.block.x, how.block.y, how.block.z};
    if (u64(kernel->registers()) * block.count() > kRegisters || how.sharedBytes > kSharedBytes)
        return cudaErrorLaunchOutOfResources;
    const Program& program = kernel->decoded(r.settings);
    ++kernel->launches;
    if (r.settings.trace)
        std::fprintf(stderr, "launch %s: %u x %u%s\n", kernel->name.c_str(), how.grid.x, how.block.x,
                     kernel->isPrepared ? ", prepared" : "");
    const u32 number = ++r.launches;
    const auto run = [&r, &program, kernel, grid, block, number,
                      parameters = parametersOf(program.text, arguments)](const Work& work) mutable {
        auto* bytes = reinterpret_cast<u8*>(parameters.data());
        Launch state{program,    kernel->counts, r.settings, r.memory,
                     r.textures, r.garbage,      r.findings, {bytes, parameters.size() * sizeof(u64)},
                     grid,       block,          number,     std::minstd_rand(r.settings.seed + number),
                     {}};
        runLaunch(state, kernel->warps);
        tellTouched(r.streams, work, state);
    };
    r.streams.add(r.numberOf(how.stream), kernel->name, run);
    return cudaSuccess;
}

}  // namespace

extern "C" {

void** __cudaRegisterFatBinary(void* wrapper) {
    struct Wrapper {
        int magic, version;
        const void* image;
        void* unused;
    };
    return Runtime::get().setUp([&](Runtime& r) {
        return reinterpret_cast<void**>(
            &r.kernels.addModule(embeddedCode(static_cast<const Wrapper*>(wrapper)->image)));
    });
}
void __cudaRegisterFatBinaryEnd(void**) {}
void __cudaUnregisterFatBinary(void**) {}
char __cudaInitModule(void**) {
    return 0;
}
void __cudaRegisterFunction(void** module, const char* host, char*, const char* name, int, uint3*, uint3*, dim3*, dim3*,
                            int*) {
    Runtime::get().setUp([&](Runtime& r) { r.kernels.add(host, *reinterpret_cast<EmbeddedModule*>(module), name); });
}

unsigned __cudaPushCallConfiguration(dim3 grid, dim3 block, std::size_t sharedBytes, CUstream_st* stream) {
    configurations.push_back({grid, block, sharedBytes, stream});
    return 0;
}
cudaError_t __cudaPopCallConfiguration(dim3* grid, dim3* block, std::size_t* sharedBytes, void* stream) {
    if (configurations.empty())
        return cudaErrorMissingConfiguration;
    const Configuration& last = configurations.back();
    *grid = last.grid;
    *block = last.block;
    *sharedBytes = last.sharedBytes;
    *static_cast<cudaStream_t*>(stream) = last.stream;
    configurations.pop_back();
    return cudaSuccess;
}
cudaError_t __cudaGetKernel(cudaKernel_t* kernel, const void* host) {
    return Runtime::get().call("__cudaGetKernel", [&](Runtime&) {
        *kernel = reinterpret_cast<cudaKernel_t>(const_cast<void*>(host));
        return cudaSuccess;
    });
}
cudaError_t __cudaLaunchKernel(cudaKernel_t kernel, dim3 grid, dim3 block, void** arguments, std::size_t sharedBytes,
                               cudaStream_t stream) {
    return Runtime::get().call("__cudaLaunchKernel", [&](Runtime& r) {
        return kernel != nullptr ? launch(r, kernel, {grid, block, sharedBytes, stream}, arguments)
                                 : cudaErrorInvalidResourceHandle;
    });
}
cudaError_t cudaLaunchKernel(const void* host, dim3 grid, dim3 block, void** arguments, std::size_t sharedBytes,
                             cudaStream_t stream) {
    return Runtime::get().call("cudaLaunchKernel", [&](Runtime& r) {
        return launch(r, host, {grid, block, sharedBytes, stream}, arguments);
    });
}
cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* attributes, const void* host) {
    return Runtime::get().call("cudaFuncGetAttributes", [&](Runtime& r) {
        Kernel* kernel = r.kernels.find(host);
        if (kernel == nullptr)
            return cudaErrorInvalidDeviceFunction;
        if (!kernel->runsOn(r.settings.capability))
            return cudaErrorNoKernelImageForDevice;
        *attributes = {};
        attributes->numRegs = kernel->registers();
        kernel->isPrepared = true;
        return cudaSuccess;
    });
}
cudaError_t cudaOccupancyMaxActiveBlocksPerMultiprocessor(int* blocks, const void* host, int threads, std::size_t) {
    return Runtime::get().call("cudaOccupancyMaxActiveBlocksPerMultiprocessor", [&](Runtime& r) {
        const Kernel* kernel = r.kernels.find(host);
        if (kernel == nullptr)
            return cudaErrorInvalidDeviceFunction;
        if (!kernel->runsOn(r.settings.capability))
            return cudaErrorNoKernelImageForDevice;
        *blocks = kernel->blocksPerProcessor(threads);
        return cudaSuccess;
    });
}

}  // extern "C"
