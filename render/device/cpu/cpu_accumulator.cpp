#include "render/device/cpu/cpu_accumulator.h"

#include <cassert>
#include <utility>

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

Result<void> CpuAccumulator::resolve(const Display& display, std::stop_token stop) {
    shown_.push_back(development_.picture(film_, display, stop));
    return {};
}

Result<Picture> CpuAccumulator::readback() {
    assert(!shown_.empty());
    Picture oldest = std::move(shown_.front());
    shown_.pop_front();
    return oldest;
}

Result<void> CpuAccumulator::resume(const Film& film) {
    assert(film.area() == film_.area());
    film_ = Film(film_.revision(), film.content());
    development_ = {};
    return {};
}

Result<void> CpuAccumulator::restart(const Tile& area, std::uint64_t revision) {
    shown_.clear();
    development_ = {};
    film_.restart(area, revision);
    return {};
}

}  // namespace pdr
