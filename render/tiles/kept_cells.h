#pragma once
/// Remembers which worker has rendered a cell last. That worker still has the sums and moments that it has sent, so
/// they need not travel back to it when it goes on with the cell. Only a hint: what a worker keeps, it may lose.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "render/film/tile_progress.h"
#include "render/tiles/tile_scheduler.h"

namespace pdr {

/// What who has rendered a cell's samples, result by result, knows of them.
struct KnownSamples {
    static constexpr std::uint64_t kNothing = std::numeric_limits<std::uint64_t>::max();

    std::uint64_t sums = kNothing;  ///< number of the sample after those of the running block's sums
    /// Number of the sample after those of the moments of whole blocks; those of no sample need not be known.
    std::uint64_t moments = 0;

    /// Takes in a result of these samples.
    void took(SampleRange samples);
    /// Whether these samples can be added to what is known.
    bool isContinuedBy(SampleRange samples) const;
};

/// Calls cell(tile) for each cell of a tile, row by row.
template <class Cell>
void eachCell(const Tile& tile, Cell&& cell) {
    for (int y = tile.y; y < tile.y + tile.height; y += kFilmCell)
        for (int x = tile.x; x < tile.x + tile.width; x += kFilmCell)
            cell(Tile{x, y, std::min(kFilmCell, tile.x + tile.width - x),
                      std::min(kFilmCell, tile.y + tile.height - y)});
}

/// The cells of a scene's film. Not thread-safe: see pool_state.h.
class KeptCells {
  public:
    void clear() { cells_.clear(); }
    /// Records that a film has taken a result of that worker, or of the own device.
    void took(WorkerId worker, const Tile& tile, SampleRange samples);
    /// Records that a worker has lost all that it kept, or has left.
    void forget(WorkerId worker);
    /// Whether `worker` has all that these samples continue. Samples that continue nothing: no.
    bool has(WorkerId worker, const Tile& tile, SampleRange samples) const;

    /// Cuts goals into tiles that one worker has rendered the samples of, up to TileGoal::next.
    std::vector<TileGoal> byKeeper(const std::vector<TileGoal>& goals) const;

  private:
    struct Kept {
        WorkerId worker = kOwnDevice;
        KnownSamples known;
    };
    WorkerId keeperOf(const Tile& cell, std::uint64_t next) const;

    std::map<std::pair<int, int>, Kept> cells_;  ///< by the x and y of each cell's corner
};

}  // namespace pdr
