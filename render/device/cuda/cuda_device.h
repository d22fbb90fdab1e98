#pragma once
/// NVIDIA GPUs as devices.

#include <memory>
#include <vector>

#include "render/device/device.h"
#include "render/device/preparation.h"

namespace pdr {

/// Returns the GPUs of this machine, in the runtime's order. Errors: why there is none: no driver, one that is too old,
/// no GPU.
Result<std::vector<DeviceInfo>> cudaDevices();

/// Makes the device of GPU number `index`. `preparing` is called around what its driver must translate, within
/// Device::upload(). Errors: cudaDevices()'s, no such number, or the GPU's own.
Result<std::unique_ptr<Device>> makeCudaDevice(int index = 0, const PreparationObserver& preparing = {});

}  // namespace pdr
