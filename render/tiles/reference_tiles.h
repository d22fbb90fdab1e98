#pragma once
/// Small reference images of all models. Devices that agree on all bits of these agree on the bits of every exactly
/// filtered image, and may fill one film together.

#include <cstddef>
#include <vector>

#include "render/device/device.h"

namespace pdr {

/// Renders the reference images and returns their sums as bytes. Unloads the scene of `device`. Errors: the device's.
Result<std::vector<std::byte>> referenceTiles(Device& device);

}  // namespace pdr
