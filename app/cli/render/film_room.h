#pragma once
/// Memory check for large images, with a message for the user at a terminal.

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/device/device.h"

namespace pdr::app {

/// Writes to standard error how much memory a film of 1 GB or more takes and how much is free. Errors: the film does
/// not fit.
Result<void> roomForFilm(ivec2 size, const DeviceInfo& device);

}  // namespace pdr::app
