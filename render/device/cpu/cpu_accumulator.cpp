#include "render/device/cpu/cpu_accumulator.h"

#include <algorithm>
#include <vector>

namespace pdr {

namespace {

/// Divides a tile into pieces of whole cells, each of about so many pixels: rows of cells, or parts of one row.
std::vector<Tile> pieces(const Tile& tile, double pixels) {
    const auto cells = [](double edge, int most) {
        return int(std::clamp(edge / kFilmCell, 1.0, double(cellsIn(most)))) * kFilmCell;
    };
    const int height = cells(pixels / tile.width, tile.height), width = cells(pixels / height, tile.width);
    std::vector<Tile> pieces;
    for (int y = 0; y < tile.height; y += height)
        for (int x = 0; x < tile.width; x += width)
            pieces.push_back(
                {tile.x + x, tile.y + y, std::min(width, tile.width - x), std::min(height, tile.height - y)});
    return pieces;
}

}  // namespace

Result<void> CpuAccumulator::accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) {
    const TileProgress& progress = film_.progress();
    for (const EvenTile& even : progress.evenTiles(progress.cellsAround(region)))
        take(even, n, stop, stop);
    return {};
}

Result<std::uint64_t> CpuAccumulator::extend(std::uint64_t had, std::uint32_t n, std::stop_token stop,
                                             const Extended& told) {
    if (film_.samples().most == 0)
        return begin(n, stop);
    constexpr double kPathsPerPiece = 1 << 17;  // of each thread: about a tenth of a second
    for (const EvenTile& even : film_.progress().evenTiles(film_.area()))
        for (const Tile& piece : pieces(even.tile, kPathsPerPiece * tracer_.threads() / n)) {
            take({piece, even.next}, n, stop, {});
            if (stop.stop_requested())
                return film_.samplesPerPixel();
            if (told)
                told(film_.samples());
        }
    return had + n;
}

/// Takes the first samples. A stop request ends them at once and leaves none: there is nothing to lose.
Result<std::uint64_t> CpuAccumulator::begin(std::uint32_t n, const std::stop_token& stop) {
    take({film_.area(), film_.progress().first()}, n, stop, stop);
    if (!stop.stop_requested())
        return n;
    film_.restart(film_.area(), film_.revision());
    return 0;
}

/// Takes n more samples of a tile, block by block, until `end`. `breakOff` ends a block as well, and leaves worthless
/// sums.
void CpuAccumulator::take(const EvenTile& from, std::uint32_t n, const std::stop_token& end,
                          const std::stop_token& breakOff) {
    for (std::uint32_t taken = 0; taken < n && !end.stop_requested();) {
        const SampleRange block = samplesInBlock(from.next + taken, n - taken);
        tracer_.trace(scene_->flat, from.tile, block, film_.sums(from.tile), breakOff);
        if (breakOff.stop_requested())
            return;
        film_.commit(from.tile, block);
        taken += block.count;
    }
}

}  // namespace pdr
