#pragma once
/// Measurement of a case on a device.

#include <functional>

#include "app/selftest/verdict.h"
#include "render/device/device.h"

namespace pdr::selftest {

/// Callback that returns true if the measurement is to stop soon.
using Cancelled = std::function<bool()>;

/// Measures a case with about `samples` samples. Each `seed` gives independent random numbers. Phase-function moments
/// are sampled on the host, with the kernel's own function. Errors: the device fails; cancelled().
Result<Measurement> measure(Device& device, const Case& reference, std::uint64_t samples, std::uint64_t seed,
                            const Cancelled& cancelled);

}  // namespace pdr::selftest
