#pragma once
/// Available memory. Programs check it before large allocations: Linux promises more memory than there is and kills the
/// program later.

#include <cstdint>

#include "render/base/memory_group.h"

namespace pdr {

/// Returns the bytes that this program may still allocate: the least of what the machine, its control groups and its
/// own limit (RLIMIT_AS) leave. A limit that cannot be read counts as kNoMemoryLimit.
std::uint64_t freeBytes();

}  // namespace pdr
