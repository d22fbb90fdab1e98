#pragma once
/// Whether there is memory for a picture, before hours are spent on it.

#include <cstdint>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/device/device.h"

namespace pdr::app {

/// Bytes of the host's memory that a film of `size` pixels takes until its picture is written: the film, unless it is
/// elsewhere, the copy that is written, and a picture of both.
std::uint64_t filmBytes(ivec2 size, const DeviceInfo& device);

/// Bytes that this program may still take: of the machine, of its group of processes and of its own limit the least.
/// What cannot be found out counts as no limit.
std::uint64_t freeBytes();

/// Says on standard error what a large film takes and what is free. Errors: it does not fit.
Result<void> roomForFilm(ivec2 size, const DeviceInfo& device);

}  // namespace pdr::app
