#include "render/device/emulated/emulated_gpu.h"

#include "render/device/emulated/host_gpu.h"
#include "render/device/gpu_device.h"

namespace pdr {

std::unique_ptr<Device> makeEmulatedGpu(int threads) {
    constexpr std::size_t kAllMemory = 0;
    return std::make_unique<GpuDevice<HostGpu>>(DeviceInfo{"emulated", "a GPU emulated on the CPU", false}, kAllMemory,
                                                threads);
}

}  // namespace pdr
