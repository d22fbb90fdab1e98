#include "app/node/kept_sums.h"

#include <algorithm>
#include <utility>

namespace pdr::node {
namespace {

/// Calls row(in the tile, in the cell, pixels) with the index of the first pixel of each row of a cell.
template <class Row>
void eachRow(const Tile& tile, const Tile& cell, Row&& row) {
    for (int y = 0; y < cell.height; ++y)
        row(std::size_t(cell.y - tile.y + y) * std::size_t(tile.width) + std::size_t(cell.x - tile.x),
            std::size_t(y) * std::size_t(cell.width), std::size_t(cell.width));
}

template <class Pixel>
std::vector<Pixel> cutOut(const std::vector<Pixel>& pixels, const Tile& tile, const Tile& cell) {
    std::vector<Pixel> cut(pixels.empty() ? 0 : pixelCount(cell));
    if (!cut.empty())
        eachRow(tile, cell, [&](std::size_t from, std::size_t to, std::size_t n) {
            std::copy_n(pixels.begin() + std::ptrdiff_t(from), n, cut.begin() + std::ptrdiff_t(to));
        });
    return cut;
}

template <class Pixel>
void putIn(const std::vector<Pixel>& cut, const Tile& cell, const Tile& tile, std::vector<Pixel>& pixels) {
    eachRow(tile, cell, [&](std::size_t to, std::size_t from, std::size_t n) {
        std::copy_n(cut.begin() + std::ptrdiff_t(from), n, pixels.begin() + std::ptrdiff_t(to));
    });
}

}  // namespace

void KeptSums::keep(const LeaseResult& result) {
    const std::uint64_t pixels = pixelCount(result.tile);
    if (pixels_ + pixels > kMostPixels)
        clear();
    if (pixels > kMostPixels)
        return;
    eachCell(result.tile, [&](const Tile& tile) {
        Cell& cell = cells_[{tile.x, tile.y}];
        if (cell.tile != tile) {
            pixels_ += pixelCount(tile) - pixelCount(cell.tile);
            cell = {tile, {}, {}, {}, {}};
        }
        take(cell, result);
    });
}

/// Brings the cell from where it is to the end of the result's samples.
void KeptSums::take(Cell& cell, const LeaseResult& result) {
    cell.known.took(result.samples);
    cell.sums = cutOut(result.sums, result.tile, cell.tile);
    const bool knowsAll = cell.known.moments != KnownSamples::kNothing;
    if (!knowsAll || fromBlockStart(result.samples).first == 0 || cell.seen.empty())
        cell.seen.assign(cell.sums.size(), 0);
    for (std::size_t i = 0; i < cell.sums.size(); ++i)
        cell.sums[i].seen = cell.seen[i] |= cell.sums[i].seen;
    if (isDeep(result.samples)) {
        cell.moments = cutOut(result.moments, result.tile, cell.tile);
    } else if (!knowsAll || fromBlockStart(result.samples).first == 0) {
        cell.moments.clear();
    }
    const bool endsBlock = cell.known.sums == KnownSamples::kNothing;
    if (endsBlock && knowsAll && !isDeep(result.samples)) {
        cell.moments.resize(cell.sums.size());
        for (std::size_t i = 0; i < cell.sums.size(); ++i)
            cell.moments[i] = merged(cell.moments[i], cell.sums[i]);
    }
    if (endsBlock)
        cell.sums.clear();
}

bool KeptSums::fill(Lease& lease) const {
    const bool deep = isDeep(lease.samples);
    bool all = true;
    std::vector<PixelSums> sums(deep ? 0 : pixelCount(lease.tile));
    std::vector<Moments> moments(deep ? pixelCount(lease.tile) : 0);
    eachCell(lease.tile, [&](const Tile& tile) {
        const auto found = cells_.find({tile.x, tile.y});
        all = all && found != cells_.end() && found->second.tile == tile &&
              found->second.known.isContinuedBy(lease.samples);
        if (!all)
            return;
        if (deep)
            putIn(found->second.moments, tile, lease.tile, moments);
        else
            putIn(found->second.sums, tile, lease.tile, sums);
    });
    if (!all)
        return false;
    lease.before = std::move(sums);
    lease.moments = std::move(moments);
    return true;
}

void KeptSums::clear() {
    cells_.clear();
    pixels_ = 0;
}

}  // namespace pdr::node
