#include "render/device/emulated/emulated_gpu.h"

#include "render/device/emulated/host_gpu.h"
#include "render/device/gpu_device.h"

namespace pdr {

namespace {

std::unique_ptr<Device> emulated(const DeviceInfo& info, int threads, HostGpu::Walks walks) {
    constexpr std::size_t kAllMemory = 0;
    return std::make_unique<GpuDevice<HostGpu>>(info, kAllMemory, threads, walks);
}

}  // namespace

std::unique_ptr<Device> makeEmulatedGpu(int threads) {
    return emulated({"emulated", "a GPU emulated on the CPU", false}, threads, HostGpu::Walks::oneByOne);
}

std::unique_ptr<Device> makeLockstepGpu(int threads) {
    return emulated({"lockstep", "a GPU emulated on the CPU, its warps in step", false}, threads,
                    HostGpu::Walks::inWarps);
}

}  // namespace pdr
