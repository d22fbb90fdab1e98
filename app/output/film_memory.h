#pragma once
/// Checks that there is memory for an image before hours are spent on it.

#include <cstdint>
#include <string>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/device/device.h"

namespace pdr::app {

/// Returns the bytes of host memory that a film of `size` pixels takes until its image is written: the film, unless the
/// device holds it elsewhere, the copy that is written, and the image itself.
std::uint64_t filmBytes(ivec2 size, const DeviceInfo& device);

/// Checks that the film fits into free memory. `hint`: what the user can do about it. Error: it does not fit.
Result<void> checkFilmFits(ivec2 size, const DeviceInfo& device, const Text& hint);

}  // namespace pdr::app
