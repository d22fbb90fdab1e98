#pragma once
/// Small reference pictures of all models. Devices that agree on all of their bits agree on those of every exactly
/// filtered picture, and may fill one film together.

#include <cstddef>
#include <vector>

#include "render/device/device.h"

namespace pdr {

/// The pictures' sums, as bytes. Unloads the scene that `device` held. Errors: the device's.
Result<std::vector<std::byte>> referenceTiles(Device& device);

}  // namespace pdr
