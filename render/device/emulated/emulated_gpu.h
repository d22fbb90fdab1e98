#pragma once
/// A GPU that the CPU's threads play: the programs of GPUs, their memory and their texture units. Slow; for tests, and
/// to learn without a GPU what a choice that only GPUs know does to a picture.

#include <memory>

#include "render/device/device.h"

namespace pdr {

/// `threads` 0 = one per core. Not among devicesHere().
std::unique_ptr<Device> makeEmulatedGpu(int threads = 0);

/// The same whose queues are walked by warps in step, by the text that does so on a GPU. Slower still.
std::unique_ptr<Device> makeLockstepGpu(int threads = 0);

}  // namespace pdr
