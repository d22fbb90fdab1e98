#include "render/tiles/kept_cells.h"

namespace pdr {
namespace {

/// Appends runs of cells to `tiles`, as tiles that are as high as the same run is in the rows below.
void pileUp(const std::vector<TileGoal>& runs, std::vector<TileGoal>& tiles) {
    const auto first = std::ptrdiff_t(tiles.size());
    for (const TileGoal& run : runs) {
        const auto above = std::find_if(tiles.begin() + first, tiles.end(), [&](const TileGoal& one) {
            return one.keeper == run.keeper && one.tile.x == run.tile.x && one.tile.width == run.tile.width &&
                   one.tile.y + one.tile.height == run.tile.y;
        });
        if (above == tiles.end())
            tiles.push_back(run);
        else
            above->tile.height += run.tile.height;
    }
}

}  // namespace

void KnownSamples::took(SampleRange samples) {
    const std::uint64_t block = fromBlockStart(samples).first;
    const bool knowsBefore = isDeep(samples) || block == 0 || moments == block;
    const bool isWhole = samples.end() % kSamplesPerBlock == 0;
    sums = isWhole ? kNothing : samples.end();
    moments = !knowsBefore ? kNothing : isWhole ? samples.end() : block;
}

bool KnownSamples::isContinuedBy(SampleRange samples) const {
    if (isDeep(samples))
        return samples.first > 0 && moments == samples.first;
    return samples.first % kSamplesPerBlock != 0 && sums == samples.first && moments != kNothing;
}

void KeptCells::took(WorkerId worker, const Tile& tile, SampleRange samples) {
    eachCell(tile, [&](const Tile& cell) {
        Kept& kept = cells_[{cell.x, cell.y}];
        if (kept.worker != worker)
            kept = {worker, {}};
        kept.known.took(samples);
    });
}

void KeptCells::forget(WorkerId worker) {
    std::erase_if(cells_, [&](const auto& one) { return one.second.worker == worker; });
}

bool KeptCells::has(WorkerId worker, const Tile& tile, SampleRange samples) const {
    bool all = true;
    eachCell(tile, [&](const Tile& cell) {
        const auto kept = cells_.find({cell.x, cell.y});
        all = all && kept != cells_.end() && kept->second.worker == worker && kept->second.known.isContinuedBy(samples);
    });
    return all;
}

WorkerId KeptCells::keeperOf(const Tile& cell, std::uint64_t next) const {
    const auto kept = cells_.find({cell.x, cell.y});
    if (kept == cells_.end() || next == 0)
        return kOwnDevice;
    const KnownSamples& known = kept->second.known;
    return known.sums == next || known.moments == next ? kept->second.worker : kOwnDevice;
}

std::vector<TileGoal> KeptCells::byKeeper(const std::vector<TileGoal>& goals) const {
    std::vector<TileGoal> cut;
    for (const TileGoal& goal : goals) {
        std::vector<TileGoal> runs;
        eachCell(goal.tile, [&](const Tile& cell) {
            const WorkerId keeper = keeperOf(cell, goal.next);
            if (!runs.empty() && runs.back().tile.y == cell.y && runs.back().keeper == keeper)
                runs.back().tile.width += cell.width;
            else
                runs.push_back({cell, goal.next, goal.goal, keeper});
        });
        pileUp(runs, cut);
    }
    return cut;
}

}  // namespace pdr
