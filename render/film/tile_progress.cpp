#include "render/film/tile_progress.h"

#include <algorithm>

namespace pdr {

TileProgress::TileProgress(const Tile& area, std::uint64_t first)
    : area_(area),
      first_(first),
      columns_(cellsIn(area.width)),
      next_(std::size_t(columns_) * std::size_t(cellsIn(area.height)), first) {}

Tile TileProgress::cellsOf(const Tile& pixels) const {
    const int x = (pixels.x - area_.x) / kFilmCell, y = (pixels.y - area_.y) / kFilmCell;
    return {x, y, cellsIn(pixels.x - area_.x + pixels.width) - x, cellsIn(pixels.y - area_.y + pixels.height) - y};
}

Tile TileProgress::pixelsOf(const Tile& cells) const {
    const int x = cells.x * kFilmCell, y = cells.y * kFilmCell;
    return {area_.x + x, area_.y + y, std::min(cells.width * kFilmCell, area_.width - x),
            std::min(cells.height * kFilmCell, area_.height - y)};
}

Tile TileProgress::cellsAround(const Tile& region) const {
    if (region.width <= 0 || region.height <= 0)
        return {region.x, region.y, 0, 0};
    return pixelsOf(cellsOf(region));
}

/// Grows each tile from the first cell that is in none yet, first as wide as its row allows and then as high.
std::vector<EvenTile> TileProgress::evenTiles(const Tile& cells) const {
    std::vector<EvenTile> tiles;
    if (cells.width <= 0 || cells.height <= 0)
        return tiles;
    const Tile all = cellsOf(cells);
    std::vector<bool> taken(next_.size());
    const auto isFree = [&](int x, int y, std::uint64_t next) {
        return !taken[std::size_t(y) * columns_ + x] && at(x, y) == next;
    };
    for (int y = all.y; y < all.y + all.height; ++y)
        for (int x = all.x; x < all.x + all.width; ++x) {
            const std::uint64_t next = at(x, y);
            if (!isFree(x, y, next))
                continue;
            int right = x + 1, below = y + 1;
            while (right < all.x + all.width && isFree(right, y, next))
                ++right;
            const auto rowIsFree = [&](int row) {
                for (int column = x; column < right; ++column)
                    if (!isFree(column, row, next))
                        return false;
                return true;
            };
            while (below < all.y + all.height && rowIsFree(below))
                ++below;
            for (int row = y; row < below; ++row)
                std::fill_n(taken.begin() + std::ptrdiff_t(row) * columns_ + x, right - x, true);
            tiles.push_back({pixelsOf({x, y, right - x, below - y}), next});
        }
    return tiles;
}

void TileProgress::advance(const Tile& cells, std::uint64_t next) {
    if (cells.width <= 0 || cells.height <= 0)
        return;
    const Tile all = cellsOf(cells);
    for (int y = all.y; y < all.y + all.height; ++y)
        std::fill_n(&at(all.x, y), all.width, next);
}

SampleCounts TileProgress::counts(const Tile& part) const {
    if (part.width <= 0 || part.height <= 0)
        return {};
    const Tile cells = cellsOf(part);
    SampleCounts counts{at(cells.x, cells.y) - first_, 0, 0};
    double pixels = 0;
    for (int y = cells.y; y < cells.y + cells.height; ++y) {
        const int height = std::min(kFilmCell, area_.height - y * kFilmCell);
        for (int x = cells.x; x < cells.x + cells.width; ++x) {
            const std::uint64_t samples = at(x, y) - first_;
            const double here = double(std::min(kFilmCell, area_.width - x * kFilmCell)) * height;
            counts.least = std::min(counts.least, samples);
            counts.most = std::max(counts.most, samples);
            counts.mean += double(samples) * here;
            pixels += here;
        }
    }
    counts.mean = counts.least == counts.most ? double(counts.least) : counts.mean / pixels;
    return counts;
}

}  // namespace pdr
