#pragma once
/// The part of a request that the own device renders beside the workers.

#include <stop_token>

#include "render/device/device.h"
#include "render/tiles/shared_work.h"

namespace pdr {

/// Renders leases and audits of the request that `work` has begun until it is done, or `stop` is requested. Calls
/// `told` several times a second. Errors: the device's, or sums that the film refuses.
Result<void> takeOwnPart(Device& own, SharedWork& work, const std::stop_token& stop, const Extended& told = {});

/// Adds `samples` of one block to `sums`, as Device::trace() does, on the own device and on the workers that have that
/// scene; their leases are parts of `tile`, whole cells of the image.
Result<void> traceTogether(Device& own, SharedWork& work, std::uint64_t scene, const Tile& tile, SampleRange samples,
                           TileSums sums, const std::stop_token& stop);

}  // namespace pdr
