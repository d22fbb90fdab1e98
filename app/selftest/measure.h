#pragma once
/// What a device makes of a case.

#include <functional>

#include "app/selftest/verdict.h"
#include "render/device/device.h"

namespace pdr::selftest {

/// True: stop soon.
using Cancelled = std::function<bool()>;

/// Takes about `samples` samples with random numbers of their own for each `seed`. Phase-function moments are drawn on
/// the host, by the kernel's own function. Errors: the device fails; cancelled().
Result<Measurement> measure(Device& device, const Case& reference, std::uint64_t samples, std::uint64_t seed,
                            const Cancelled& cancelled);

}  // namespace pdr::selftest
