#include "render/device/host_accumulator.h"

#include <cassert>
#include <utility>

namespace pdr {

Result<void> HostAccumulator::resolve(const Display& display, std::stop_token stop) {
    shown_.push_back(development_.image(film_, display, stop));
    return {};
}

Result<Image> HostAccumulator::readback() {
    assert(!shown_.empty());
    Image oldest = std::move(shown_.front());
    shown_.pop_front();
    return oldest;
}

Result<void> HostAccumulator::resume(const Film& film) {
    assert(film.area() == film_.area());
    film_ = Film(film_.revision(), film.content());
    development_ = {};
    return {};
}

Result<void> HostAccumulator::restart(const Tile& area, std::uint64_t revision) {
    shown_.clear();
    development_ = {};
    film_.restart(area, revision);
    return {};
}

}  // namespace pdr
