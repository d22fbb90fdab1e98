#include "render/tiles/trace_lease.h"

#include <chrono>
#include <utility>

namespace pdr {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Takes the blocks one by one on a film of the tile, which adds them up as that of the image would.
Result<LeaseResult> traceBlocks(Device& device, Lease lease, const std::stop_token& stop) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t pixels = pixelCount(lease.tile);
    lease.moments.resize(pixels);
    Film film(0, {TileProgress(lease.tile, lease.samples.first), std::move(lease.moments),
                  std::vector<PixelSums>(pixels), Health()});
    for (SampleRange block{lease.samples.first, kSamplesPerBlock}; block.first < lease.samples.end();
         block.first += kSamplesPerBlock) {
        if (Result<void> traced = device.trace(lease.tile, block, film.sums(lease.tile), stop); !traced)
            return traced.error();
        if (stop.stop_requested())
            break;
        film.commit(block);
    }
    FilmContent taken = film.content();
    return LeaseResult{lease.number, lease.tile,          lease.samples,           std::move(taken.block),
                       taken.health, secondsSince(start), std::move(taken.moments)};
}

}  // namespace

Result<LeaseResult> traceLease(Device& device, Lease lease, const std::stop_token& stop) {
    if (isDeep(lease.samples))
        return traceBlocks(device, std::move(lease), stop);
    const auto start = std::chrono::steady_clock::now();
    LeaseResult result{lease.number, lease.tile, lease.samples, std::move(lease.before), {}, 0, {}};
    result.sums.resize(pixelCount(lease.tile));
    const TileSums sums{result.sums.data(), lease.tile.width, &result.health};
    if (Result<void> traced = device.trace(lease.tile, lease.samples, sums, stop); !traced)
        return traced.error();
    result.seconds = secondsSince(start);
    return result;
}

}  // namespace pdr
