#include "render/session/sweep.h"

#include <algorithm>

namespace pdr {

void Sweep::begin(std::uint32_t n) {
    const std::uint64_t least = samplesOf(part_);
    std::uint64_t ahead = least + n;
    for (const EvenTile& even : progress_.evenTiles(part_))
        if (const std::uint64_t samples = even.next - progress_.first(); samples > least)
            ahead = std::min(ahead, samples);
    n_ = std::uint32_t(ahead - least);
    goal_ = ahead;
}

Sweep::Order Sweep::next(double pixels) const {
    for (const EvenTile& even : progress_.evenTiles(part_)) {
        if (even.next - progress_.first() >= goal_)
            continue;
        Tile tile = even.tile;
        if (pixels < double(pixelCount(tile)))
            tile.height = std::min(tile.height, std::max(int(pixels / tile.width) / kFilmCell, 1) * kFilmCell);
        return {tile, n_};
    }
    return {};
}

std::uint32_t Sweep::took(const Order& order) {
    for (const EvenTile& even : progress_.evenTiles(order.tile))
        progress_.advance(even.tile, even.next + order.n);
    return isHalfMade() ? 0 : n_;
}

}  // namespace pdr
