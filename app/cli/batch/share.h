#pragma once
/// The share of an image that one of several machines renders, which know nothing of each other.

#include <string_view>
#include <vector>

#include "render/base/result.h"
#include "render/base/tile.h"

namespace pdr::app {

/// One of several shares of an image. All of them together are the image.
struct Share {
    int number = 1;  ///< from 1
    int of = 1;
    bool operator==(const Share&) const = default;
};

/// Largest number of shares of an image of `size` pixels: the cells that it has (film/tile_progress.h).
int mostShares(ivec2 size);
/// Returns the tiles of a share of an image of `size` pixels: cells that follow each other row by row, as many as the
/// other shares have, or one more. `share.of` is at most mostShares().
std::vector<Tile> tilesOf(const Share& share, ivec2 size);
/// Returns the number of pixels in all of `tiles`.
std::size_t pixelsIn(const std::vector<Tile>& tiles);

/// Reads "3/200". Error: it is no share.
Result<Share> readShare(std::string_view text);

}  // namespace pdr::app
