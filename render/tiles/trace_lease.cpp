#include "render/tiles/trace_lease.h"

#include <chrono>
#include <utility>

namespace pdr {

Result<LeaseResult> traceLease(Device& device, Lease lease, const std::stop_token& stop) {
    const auto start = std::chrono::steady_clock::now();
    LeaseResult result{lease.number, lease.tile, lease.samples, std::move(lease.before), {}, 0};
    result.sums.resize(std::size_t(lease.tile.width) * std::size_t(lease.tile.height));
    const TileSums sums{result.sums.data(), lease.tile.width, &result.health};
    if (Result<void> traced = device.trace(lease.tile, lease.samples, sums, stop); !traced)
        return traced.error();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace pdr
