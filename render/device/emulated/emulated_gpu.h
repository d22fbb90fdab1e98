#pragma once
/// GPUs emulated by the CPU's threads: their programs, their memory and their texture units. Slow; for tests, and to
/// find out without a GPU what an option that only GPUs have does to an image.

#include <memory>

#include "render/device/device.h"

namespace pdr {

/// Makes an emulated GPU; `threads` 0 = one per core. devicesHere() does not list it.
std::unique_ptr<Device> makeEmulatedGpu(int threads = 0);

/// Makes an emulated GPU whose queues are walked by warps in lockstep, with the code that runs on a GPU. Slower still.
std::unique_ptr<Device> makeLockstepGpu(int threads = 0);

}  // namespace pdr
