#pragma once
/// The devices of this machine, by the names that users write.

#include <memory>
#include <string>
#include <vector>

#include "render/device/device.h"
#include "render/device/spare_device.h"

namespace pdr {

/// The CPU first, then its GPUs. `name` is what openDevice() takes.
std::vector<DeviceInfo> devicesHere();

/// "cpu"; "cuda", the first GPU of NVIDIA's, or "cuda:1", the second; "auto": a GPU where there is one that works, else
/// the CPU; "emulated", a GPU emulated on the CPU, slow, for tests and prices; "lockstep", the same whose warps go in
/// step, slower still. `threads`: of the CPU; 0 = one per core. `told` hears why "auto" is the CPU although there is a
/// GPU. Errors: no such device, with the reason why there is none.
Result<std::unique_ptr<Device>> openDevice(const std::string& name, int threads = 0, const WhySpare& told = {});

/// As openDevice(), for programs that nobody watches: "auto" goes on on the CPU where the GPU turns out to be too old,
/// too full or broken, and `told` hears why. A computer without a GPU is nothing to tell.
Result<std::unique_ptr<Device>> openDeviceToTheEnd(const std::string& name, int threads, const WhySpare& told);

}  // namespace pdr
