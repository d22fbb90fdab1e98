#pragma once
/// What a large picture takes of the memory, for whoever waits at a terminal.

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/device/device.h"

namespace pdr::app {

/// Says on standard error what a large film takes and what is free. Errors: it does not fit.
Result<void> roomForFilm(ivec2 size, const DeviceInfo& device);

}  // namespace pdr::app
