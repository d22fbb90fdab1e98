#include "render/device/cpu/cpu_film.h"

#include <cassert>
#include <utility>

namespace pdr {

Result<void> CpuFilm::iterate(std::uint32_t n, std::stop_token stop) {
    const Tile whole{0, 0, film_.size().x, film_.size().y};
    while (n > 0) {
        const SampleRange range = film_.nextSamples(n);
        if (Result<void> rendered = device_.render(whole, range, film_.sums(whole), stop); !rendered)
            return rendered;
        if (stop.stop_requested())
            return {};
        film_.commit(range);
        n -= range.count;
    }
    return {};
}

Result<void> CpuFilm::show(const Display& display) {
    shown_.push_back(pictureOf(film_, display));
    return {};
}

Result<Picture> CpuFilm::take() {
    assert(!shown_.empty());
    Picture oldest = std::move(shown_.front());
    shown_.pop_front();
    return oldest;
}

Result<void> CpuFilm::resume(const Film& film) {
    assert(film.size() == film_.size());
    film_ = Film(film_.size(), film_.revision(), film.content());
    return {};
}

}  // namespace pdr
