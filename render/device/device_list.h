#pragma once
/// The devices of this machine, by the names that users write.

#include <memory>
#include <string>
#include <vector>

#include "render/device/device.h"
#include "render/device/preparation.h"
#include "render/device/spare_device.h"

namespace pdr {

/// Returns the CPU first, then the GPUs of this machine. `name` is what openDevice() takes.
std::vector<DeviceInfo> devicesHere();

/// Opens a device: "cpu"; "cuda", the first NVIDIA GPU, or "cuda:1", the second; "auto": a GPU if there is one that
/// works, else the CPU; "emulated", a GPU emulated on the CPU, slow, for tests and measurements; "lockstep", an
/// emulated GPU whose warps run in lockstep, slower still. `threads`: threads of the CPU; 0 = one per core. `told` gets
/// the reason why "auto" is the CPU although there is a GPU; `preparing` is called while a GPU must be prepared for its
/// first images. Errors: no such device, with the reason why there is none.
Result<std::unique_ptr<Device>> openDevice(const std::string& name, int threads = 0, const WhySpare& told = {},
                                           const PreparationObserver& preparing = {});

/// Returns `device`, which the CPU replaces if it fails, as in withSpare(); the CPU itself is returned as it is.
std::unique_ptr<Device> withCpuAsSpare(std::unique_ptr<Device> device, int threads, const WhySpare& told);

/// Opens a device like openDevice(), for programs that run unattended: "auto" continues on the CPU if the GPU turns out
/// to be too old, too full or broken, and `told` gets the reason. A computer without a GPU is not reported.
Result<std::unique_ptr<Device>> openDeviceToTheEnd(const std::string& name, int threads, const WhySpare& told,
                                                   const PreparationObserver& preparing = {});

}  // namespace pdr
