#pragma once
/// Whether there is memory for a picture, before hours are spent on it.

#include <cstdint>
#include <limits>
#include <string>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/device/device.h"

namespace pdr::app {

inline constexpr std::uint64_t kNoMemoryLimit = std::numeric_limits<std::uint64_t>::max();

/// Bytes of the host's memory that a film of `size` pixels takes until its picture is written: the film, unless it is
/// elsewhere, the copy that is written, and a picture of both.
std::uint64_t filmBytes(ivec2 size, const DeviceInfo& device);

/// Bytes that this program may still take: of the machine, of its group of processes and of its own limit the least.
/// What cannot be found out counts as kNoMemoryLimit.
std::uint64_t freeBytes();

/// `hint`: what to do about it. Errors: it does not fit.
Result<void> checkFilmFits(ivec2 size, const DeviceInfo& device, const std::string& hint);

}  // namespace pdr::app
