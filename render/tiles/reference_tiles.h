#pragma once
/// Known pictures, small ones of all models: devices that make the same bits of them make the same bits of all that is
/// filtered exactly, and may fill one film together.

#include <cstddef>
#include <vector>

#include "render/device/device.h"

namespace pdr {

/// All numbers of the pictures' sums. What `device` held before is forgotten. Errors: the device's.
Result<std::vector<std::byte>> referenceTiles(Device& device);

}  // namespace pdr
