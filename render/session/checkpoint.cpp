/// When a copy of the film is due, and how it is taken.

#include "render/session/checkpoint.h"

#include <algorithm>
#include <utility>

#include "render/device/accumulator.h"

namespace pdr {

void Checkpoint::reset(std::shared_ptr<const Film> film) {
    film_ = std::move(film);
    takenAt_ = clock_();
    seconds_ = 0;
}

bool Checkpoint::isDue() const {
    return clock_() - takenAt_ >= std::max(kSeconds, seconds_ / kShare);
}

Result<void> Checkpoint::take(Accumulator& film) {
    const double start = clock_();
    Result<std::shared_ptr<const Film>> copy = film.film();
    if (!copy)
        return copy.error();
    film_ = *std::move(copy);
    takenAt_ = clock_();
    seconds_ = takenAt_ - start;
    return {};
}

}  // namespace pdr
