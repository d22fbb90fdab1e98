#include "app/cli/batch/share.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "render/film/tile_progress.h"

namespace pdr::app {
namespace {

/// Returns the cells [from, to) x [top, bottom) as pixels of an image of `size`.
Tile pixelsOf(int from, int to, int top, int bottom, ivec2 size) {
    const int x = from * kFilmCell, y = top * kFilmCell;
    return {x, y, std::min(to * kFilmCell, size.x) - x, std::min(bottom * kFilmCell, size.y) - y};
}

}  // namespace

int mostShares(ivec2 size) {
    return cellsIn(size.x) * cellsIn(size.y);
}

std::vector<Tile> tilesOf(const Share& share, ivec2 size) {
    const int columns = cellsIn(size.x);
    const auto start = [&](int number) { return int(std::int64_t(mostShares(size)) * (number - 1) / share.of); };
    const int begin = start(share.number), end = start(share.number + 1);
    std::vector<Tile> tiles;
    for (int cell = begin; cell < end;) {
        const int row = cell / columns, from = cell % columns;
        // Whole rows are one tile; a row that begins or ends within the share is another.
        const int rows = from == 0 ? std::max(1, end / columns - row) : 1;
        const int to = std::min(columns, from + end - cell);
        tiles.push_back(pixelsOf(from, to, row, row + rows, size));
        cell += rows * (to - from);
    }
    return tiles;
}

std::size_t pixelsIn(const std::vector<Tile>& tiles) {
    std::size_t pixels = 0;
    for (const Tile& tile : tiles)
        pixels += pixelCount(tile);
    return pixels;
}

Result<Share> readShare(std::string_view text) {
    Share share;
    const char* const end = text.data() + text.size();
    const auto [slash, wrong] = std::from_chars(text.data(), end, share.number);
    if (wrong == std::errc() && slash != end && *slash == '/') {
        const auto [rest, wrongToo] = std::from_chars(slash + 1, end, share.of);
        if (wrongToo == std::errc() && rest == end && share.number >= 1 && share.number <= share.of)
            return share;
    }
    return Error{"must be a share such as 3/200, the third of 200, not \"" + std::string(text) + "\"", "--share", ""};
}

}  // namespace pdr::app
