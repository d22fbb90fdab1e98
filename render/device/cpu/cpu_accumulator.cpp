#include "render/device/cpu/cpu_accumulator.h"

namespace pdr {

Result<void> CpuAccumulator::accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) {
    const TileProgress& progress = film_.progress();
    for (const EvenTile& even : progress.evenTiles(progress.cellsAround(region)))
        for (std::uint32_t left = n; left > 0;) {
            const SampleRange range = samplesInBlock(even.next + (n - left), left);
            tracer_.trace(scene_->flat, even.tile, range, film_.sums(even.tile), stop);
            if (stop.stop_requested())
                return {};
            film_.commit(even.tile, range);
            left -= range.count;
        }
    return {};
}

}  // namespace pdr
