#pragma once
/// Memory that is still to be had, asked before much of it is taken: Linux promises more than there is, and ends the
/// program later.

#include <cstdint>

#include "render/base/memory_group.h"

namespace pdr {

/// Bytes that this program may still take: of the machine, of its control groups and of its own limit (RLIMIT_AS) the
/// least. What cannot be found out counts as kNoMemoryLimit.
std::uint64_t freeBytes();

}  // namespace pdr
