#pragma once
/// The devices of this machine, by the names that users write.

#include <memory>
#include <string>
#include <vector>

#include "render/device/device.h"

namespace pdr {

/// The CPU first, then its GPUs. `name` is what openDevice() takes.
std::vector<DeviceInfo> devicesHere();

/// "cpu"; "cuda", the first GPU of NVIDIA's, or "cuda:1", the second; "auto": a GPU where there is one that works, else
/// the CPU; "emulated", a GPU emulated on the CPU, slow, for tests and prices; "lockstep", the same whose warps go in
/// step, slower still. `threads`: of the CPU; 0 = one per core.
/// Errors: no such device, with the reason why there is none.
Result<std::unique_ptr<Device>> openDevice(const std::string& name, int threads = 0);

}  // namespace pdr
