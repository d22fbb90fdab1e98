#pragma once
/// Whether there is memory for a picture, before hours are spent on it.

#include <cstdint>
#include <string>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/device/device.h"

namespace pdr::app {

/// Bytes of the host's memory that a film of `size` pixels takes until its picture is written: the film, unless it is
/// elsewhere, the copy that is written, and a picture of both.
std::uint64_t filmBytes(ivec2 size, const DeviceInfo& device);

/// `hint`: what to do about it. Errors: it does not fit.
Result<void> checkFilmFits(ivec2 size, const DeviceInfo& device, const Text& hint);

}  // namespace pdr::app
