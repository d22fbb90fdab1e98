#include "render/tiles/worker.h"

#include <algorithm>

#include "render/film/tile_progress.h"

namespace pdr {

void WorkerSpeed::add(double cost, double seconds) {
    cost_ = kKept * cost_ + cost;
    seconds_ = kKept * seconds_ + std::max(seconds, kShortestSeconds);
}

/// Cuts the tile into at most kOneIn parts, draws a number below kOneIn, and returns the part of that number, if any.
std::optional<Tile> Trust::partToAudit(const Tile& tile) {
    const int rows = cellsIn(tile.height), columns = cellsIn(tile.width);
    const int down = std::min(rows, kOneIn), across = std::min(columns, kOneIn / down);
    const int drawn = int(random_() % kOneIn);
    if (drawn >= down * across)
        return std::nullopt;
    const int i = drawn % across, j = drawn / across;
    const int left = columns * i / across * kFilmCell, top = rows * j / down * kFilmCell;
    const int right = std::min(columns * (i + 1) / across * kFilmCell, tile.width);
    const int bottom = std::min(rows * (j + 1) / down * kFilmCell, tile.height);
    return Tile{tile.x + left, tile.y + top, right - left, bottom - top};
}

WorkerStatus Worker::statusNow() const {
    WorkerStatus now = status;
    now.workPerSecond = speed.perSecond();
    now.isProved = trust.isProved();
    return now;
}

void Worker::count(const Portion& portion) {
    ++status.results;
    status.work += workOf(portion.tile, portion.samples);
}

void Worker::updateState() {
    if (isQuarantined())
        return;
    status.state = isDraining   ? WorkerState::draining
                   : isSuspect  ? WorkerState::suspect
                   : isPaused   ? WorkerState::paused
                   : scene == 0 ? WorkerState::waiting
                                : WorkerState::ready;
}

}  // namespace pdr
