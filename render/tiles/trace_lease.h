#pragma once
/// Renders a lease on a device.

#include <stop_token>

#include "render/device/device.h"
#include "render/tiles/lease.h"

namespace pdr {

/// Renders a lease with the scene that is on `device`. After a stop request the result is invalid. Errors: the
/// device's.
Result<LeaseResult> traceLease(Device& device, Lease lease, const std::stop_token& stop);

}  // namespace pdr
