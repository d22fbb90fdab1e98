#pragma once
/// A device takes the samples of a lease.

#include <stop_token>

#include "render/device/device.h"
#include "render/tiles/lease.h"

namespace pdr {

/// Of the scene that `device` holds. After a stop request the result is worthless. Errors: the device's.
Result<LeaseResult> traceLease(Device& device, Lease lease, const std::stop_token& stop);

}  // namespace pdr
