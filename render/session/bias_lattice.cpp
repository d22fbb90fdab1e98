#include "render/session/bias_lattice.h"

#include <chrono>
#include <utility>

#include "render/device/device.h"
#include "render/film/film.h"
#include "render/kernel/random.h"

namespace pdr {
namespace {

constexpr int kTileEdge = 4;     ///< pixels; no more: neighbours tell little that is new
constexpr int kTilesAlong = 16;  ///< the picture's edges
constexpr int kBlurReach = 1;    ///< pixels that a blurred one is made from, to either side

/// One in each cell of a grid, anywhere in it.
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

/// With the pixels around it that are blurred into it.
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

BiasLattice::BiasLattice(Scene biased) : biased_(std::move(biased)) {
    biased_.schedule.runningMean = false;  // it knows no halves, and blurs nothing
    for (const Tile& tile : latticeOf(biased_.film))
        tiles_.push_back({tile, std::vector<Pixel>(std::size_t(tile.width * tile.height))});
}

Result<void> BiasLattice::addRound(Device& device, const std::stop_token& stop) {
    Scene biased = biased_, exact = exactly(biased_);
    biased.seed ^= mixBits(2 * rounds_ + 1);
    exact.seed ^= mixBits(2 * rounds_ + 2);
    std::vector<Tiled> tiles = tiles_;
    if (auto ok = add(biased, &BothWays::biased, device, stop, tiles); !ok)
        return ok;
    if (auto ok = add(exact, &BothWays::exact, device, stop, tiles); !ok || stop.stop_requested())
        return ok;
    tiles_ = std::move(tiles);
    ++rounds_;
    return {};
}

Result<void> BiasLattice::add(const Scene& scene, HalfMeans BothWays::*way, Device& device, const std::stop_token& stop,
                              std::vector<Tiled>& tiles) const {
    if (auto ok = device.upload(scene); !ok)
        return ok;
    const auto areaOf = [&](const Tile& tile) { return scene.schedule.filter ? grown(tile, scene.film) : tile; };
    auto film = device.film(areaOf(tiles.front().tile), scene.revision, scene.schedule);
    if (!film)
        return film.error();
    for (auto& [tile, pixels] : tiles) {
        const Tile area = areaOf(tile);
        if (auto ok = (*film)->restart(area, scene.revision); !ok)
            return ok;
        if (auto ok = (*film)->accumulate(kRound, stop); !ok || stop.stop_requested())
            return ok;
        const auto known = (*film)->film();
        if (!known)
            return known.error();
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const PixelEstimate pixel = (*known)->pixel(tile.x - area.x + int(i) % tile.width,  //
                                                        tile.y - area.y + int(i) / tile.width);
            (pixels[i].sums.*way).even += pixel.halves.even;
            (pixels[i].sums.*way).odd += pixel.halves.odd;
            pixels[i].tissue |= pixel.tissue;
        }
    }
    return {};
}

std::optional<MeasuredBias> BiasLattice::measured(double exposure) const {
    std::vector<BiasTile> means;
    const auto mean = [&](const HalfMeans& sum) {
        return HalfMeans{sum.even / double(rounds_), sum.odd / double(rounds_)};
    };
    for (const Tiled& tiled : tiles_) {
        BiasTile& tile = means.emplace_back();
        for (const Pixel& pixel : tiled.pixels)
            if (pixel.tissue)
                tile.push_back({mean(pixel.sums.biased), mean(pixel.sums.exact)});
    }
    return measuredBias(means, exposure);
}

Result<std::optional<MeasuredBias>> measureBias(const Scene& biased, double exposure, Device& device, double seconds,
                                                const std::stop_token& stop) {
    const auto start = std::chrono::steady_clock::now();
    const auto taken = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
    BiasLattice lattice(biased);
    do
        if (auto ok = lattice.addRound(device, stop); !ok)
            return ok.error();
    while (!stop.stop_requested() && taken() < seconds);
    return lattice.measured(exposure);
}

}  // namespace pdr
