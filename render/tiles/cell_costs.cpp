#include "render/tiles/cell_costs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "render/film/tile_progress.h"

namespace pdr {
namespace {

/// Learning rate: below 1, since a busy machine makes cells look expensive.
constexpr double kBelieved = 0.7;
/// Limit on the ratio to the mean: an empty cell may have tissue in the next image.
constexpr double kMostContrast = 16;

}  // namespace

CellCosts::CellCosts(const Tile& area)
    : area_(area),
      columns_(cellsIn(area.width)),
      rows_(cellsIn(area.height)),
      density_(std::size_t(columns_) * std::size_t(rows_), 1.0) {
    sum();
}

CellCosts CellCosts::stretchedOver(const Tile& area) const {
    CellCosts other(area);
    if (!isKnown_)
        return other;
    for (int y = 0; y < other.rows_; ++y)
        for (int x = 0; x < other.columns_; ++x)
            other.density_[other.index(x, y)] = density_[index(x * columns_ / other.columns_, y * rows_ / other.rows_)];
    other.sum();
    other.isKnown_ = true;
    return other;
}

Tile CellCosts::cellsOf(const Tile& tile) const {
    return {(tile.x - area_.x) / kFilmCell, (tile.y - area_.y) / kFilmCell, cellsIn(tile.width), cellsIn(tile.height)};
}

int CellCosts::pixelsOf(int x, int y) const {
    return std::min(kFilmCell, area_.width - x * kFilmCell) * std::min(kFilmCell, area_.height - y * kFilmCell);
}

double CellCosts::ofSample(const Tile& tile) const {
    if (density_.empty())
        return double(pixelCount(tile));
    const Tile cells = cellsOf(tile);
    const int right = cells.x + cells.width, below = cells.y + cells.height;
    return before(right, below) - before(cells.x, below) - before(right, cells.y) + before(cells.x, cells.y);
}

void CellCosts::learn(const std::vector<TimedLease>& leases) {
    struct Total {
        double cost = 0, seconds = 0;
    };
    const auto isSense = [](const TimedLease& lease) { return lease.seconds > 0 && lease.samples > 0; };
    // Measure the speed of each worker over all of its leases
    std::map<WorkerId, Total> workers;
    for (const TimedLease& lease : leases) {
        if (!isSense(lease))
            continue;
        Total& total = workers[lease.worker];
        total.cost += ofSample(lease.tile) * lease.samples;
        total.seconds += lease.seconds;
    }
    // Attribute the excess time of each lease to its cells
    std::vector<double> surprise(density_.size()), samples(density_.size());
    for (const TimedLease& lease : leases) {
        if (!isSense(lease))
            continue;
        const Total& total = workers[lease.worker];
        const double expected = ofSample(lease.tile) * lease.samples * total.seconds / total.cost;
        const double logarithm = std::log(std::clamp(lease.seconds / expected, 1 / kMostContrast, kMostContrast));
        const Tile cells = cellsOf(lease.tile);
        for (int y = cells.y; y < cells.y + cells.height; ++y)
            for (int x = cells.x; x < cells.x + cells.width; ++x) {
                surprise[index(x, y)] += logarithm * lease.samples;
                samples[index(x, y)] += lease.samples;
            }
        isKnown_ = true;
    }
    // Update the cost of each cell
    for (std::size_t i = 0; i < density_.size(); ++i)
        if (samples[i] > 0)
            density_[i] = std::clamp(density_[i] * std::exp(kBelieved * surprise[i] / samples[i]), 1 / kMostContrast,
                                     kMostContrast);
    sum();
}

/// Normalises the mean to 1 and builds the summed-area table.
void CellCosts::sum() {
    double all = 0;
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; ++x)
            all += density_[index(x, y)] * pixelsOf(x, y);
    const double scale = double(pixelCount(area_)) / all;
    before_.assign(std::size_t(columns_ + 1) * std::size_t(rows_ + 1), 0.0);
    for (int y = 0; y < rows_; ++y) {
        double row = 0;
        for (int x = 0; x < columns_; ++x) {
            density_[index(x, y)] *= scale;
            row += density_[index(x, y)] * pixelsOf(x, y);
            before_[std::size_t(y + 1) * std::size_t(columns_ + 1) + std::size_t(x + 1)] = before(x + 1, y) + row;
        }
    }
}

}  // namespace pdr
