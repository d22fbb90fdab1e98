#include "render/session/bias_lattice.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "render/device/device.h"
#include "render/film/film.h"
#include "render/kernel/random.h"

namespace pdr {
namespace {

constexpr int kTileEdge = 4;     ///< pixels; not larger, because neighbouring pixels add little
constexpr int kTilesAlong = 16;  ///< most tiles along each edge of the image
constexpr int kBlurReach = 1;    ///< pixels to either side from which a blurred pixel is made

constexpr float kExactTolerance = 0.01f, kLeastTolerance = 1e-3f;  ///< fraction of the tolerance; display levels

/// Returns one tile in each cell of a grid, at a random place in the cell.
std::vector<Tile> latticeOf(ivec2 film) {
    const ivec2 cells = glm::clamp(film / kTileEdge, ivec2(1), ivec2(kTilesAlong));
    const ivec2 edge = glm::min(film, ivec2(kTileEdge));
    std::vector<Tile> tiles;
    for (int row = 0; row < cells.y; ++row)
        for (int column = 0; column < cells.x; ++column) {
            const ivec2 begin = film * ivec2(column, row) / cells, end = film * ivec2(column + 1, row + 1) / cells;
            const ivec2 places = end - begin - edge + 1;
            const std::uint64_t chance = mixBits(std::uint64_t(row) * kTilesAlong + std::uint64_t(column) + 1);
            tiles.push_back({begin.x + int((chance & 0xffffffff) % std::uint64_t(places.x)),
                             begin.y + int((chance >> 32) % std::uint64_t(places.y)), edge.x, edge.y});
        }
    return tiles;
}

/// Returns the tile together with the surrounding pixels that are blurred into it.
Tile grown(const Tile& tile, ivec2 film) {
    const ivec2 begin = glm::max(ivec2(tile.x, tile.y) - kBlurReach, ivec2(0));
    const ivec2 end = glm::min(ivec2(tile.x + tile.width, tile.y + tile.height) + kBlurReach, film);
    return {begin.x, begin.y, end.x - begin.x, end.y - begin.y};
}

}  // namespace

Scene exactly(Scene scene) {
    scene.estimator = Estimator::unbiased;
    scene.schedule = {};
    scene.filtering = Filtering::exact;
    return scene;
}

TwoWays withoutShortcuts(const Scene& scene) {
    TwoWays ways{scene, exactly(scene)};
    ways.biased.schedule.runningMean = false;  // it keeps no halves of the samples, and blurs nothing
    return ways;
}

TwoWays withoutRounding(const Scene& scene) {
    TwoWays ways{exactly(scene), exactly(scene), TwoWays::Samples::sameButTheFirst};
    ways.biased.schedule = {Schedule::Kind::kroes, false, false, true};
    return ways;
}

TwoWays withoutTolerance(const Scene& scene) {
    TwoWays ways{scene, exactly(scene), TwoWays::Samples::same, 4};
    ways.biased.schedule = {};
    ways.exact.toleranceLevels = std::max(kExactTolerance * scene.toleranceLevels, kLeastTolerance);
    return ways;
}

BiasLattice::BiasLattice(TwoWays ways) : ways_(std::move(ways)) {
    for (const Tile& tile : latticeOf(ways_.biased.film))
        empty_.push_back({tile, std::vector<Pixel>(std::size_t(tile.width * tile.height))});
    tiles_ = empty_;
}

Result<void> BiasLattice::addRound(Device& device, const std::stop_token& stop) {
    Scene biased = ways_.biased, exact = ways_.exact;
    biased.seed ^= mixBits(2 * rounds_ + 1);
    exact.seed ^= mixBits(2 * rounds_ + (ways_.compared == TwoWays::Samples::independent ? 2 : 1));
    std::vector<Tiled> tiles = grows() ? empty_ : tiles_;
    if (auto ok = add(biased, &BothWays::biased, device, stop, tiles); !ok)
        return ok;
    if (auto ok = add(exact, &BothWays::exact, device, stop, tiles); !ok || stop.stop_requested())
        return ok;
    tiles_ = std::move(tiles);
    samples_ = grows() ? nextRound() : samples_ + nextRound();
    ++rounds_;
    return {};
}

namespace {

/// Returns the means of a pixel after n samples. If `first`, which holds the first sample alone, is not null, that
/// sample is left out; both halves are then the mean of all remaining samples.
HalfMeans meansOf(const PixelEstimate& pixel, const PixelEstimate* first, double n) {
    if (first == nullptr)
        return pixel.halves;
    const dvec3 rest = (pixel.mean * n - first->mean) / (n - 1);
    return {rest, rest};
}

/// A film of n samples, and a film of the first sample alone if that is to be left out; null after a stop request.
struct Taken {
    std::shared_ptr<const Film> all, first;
};
Result<Taken> taken(Accumulator& film, std::uint32_t n, bool leavesOut, const std::stop_token& stop) {
    Taken taken;
    for (const std::uint32_t part : leavesOut ? std::vector<std::uint32_t>{1, n - 1} : std::vector{n}) {
        if (auto ok = film.accumulate(part, stop); !ok)
            return ok.error();
        if (stop.stop_requested())
            return Taken();
        auto known = film.film();
        if (!known)
            return known.error();
        taken.first = std::exchange(taken.all, *std::move(known));
    }
    return taken;
}

}  // namespace

Result<void> BiasLattice::add(const Scene& scene, HalfMeans BothWays::*way, Device& device, const std::stop_token& stop,
                              std::vector<Tiled>& tiles) const {
    if (auto ok = device.upload(scene); !ok)
        return ok;
    const bool blurs = scene.schedule.kind == Schedule::Kind::kroes && scene.schedule.filter;
    const bool leavesOut = grows() && way == &BothWays::exact;
    const auto areaOf = [&](const Tile& tile) { return blurs ? grown(tile, scene.film) : tile; };
    // Reuse one film for all tiles
    auto film = device.film(areaOf(tiles.front().tile), scene.revision, scene.schedule);
    if (!film)
        return film.error();
    for (auto& [tile, pixels] : tiles) {
        const Tile area = areaOf(tile);
        if (auto ok = (*film)->restart(area, scene.revision); !ok)
            return ok;
        const auto known = taken(**film, nextRound(), leavesOut, stop);
        if (!known)
            return known.error();
        if (!known->all)
            return {};
        // Add the means of the tile's pixels, without their margin
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const int x = tile.x - area.x + int(i) % tile.width, y = tile.y - area.y + int(i) / tile.width;
            const PixelEstimate pixel = known->all->pixel(x, y);
            const PixelEstimate first = leavesOut ? known->first->pixel(x, y) : PixelEstimate();
            const HalfMeans means = meansOf(pixel, leavesOut ? &first : nullptr, nextRound());
            (pixels[i].sums.*way).even += means.even;
            (pixels[i].sums.*way).odd += means.odd;
            pixels[i].tissue |= pixel.tissue;
        }
    }
    return {};
}

std::optional<MeasuredBias> BiasLattice::measured(const Tone& tone) const {
    std::vector<BiasTile> means;
    const double rounds = grows() ? 1 : double(rounds_);
    const auto mean = [&](const HalfMeans& sum) { return HalfMeans{sum.even / rounds, sum.odd / rounds}; };
    for (const Tiled& tiled : tiles_) {
        BiasTile& tile = means.emplace_back();
        for (const Pixel& pixel : tiled.pixels)
            if (pixel.tissue)
                tile.push_back({mean(pixel.sums.biased), mean(pixel.sums.exact)});
    }
    return measuredBias(means, tone);
}

}  // namespace pdr
