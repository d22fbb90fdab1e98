#include "render/tiles/own_part.h"

#include <algorithm>
#include <utility>

#include "render/tiles/trace_lease.h"

namespace pdr {
namespace {

/// The sums of a tile, row by row, and the faults of the samples that they have got since.
struct TileCopy {
    TileCopy(const Tile& tile, const TileSums& from) : tile(tile) {
        sums.reserve(pixelCount(tile));
        for (int y = 0; y < tile.height; ++y) {
            const PixelSums* row = from.pixels + std::ptrdiff_t(y) * from.stride;
            sums.insert(sums.end(), row, row + tile.width);
        }
    }
    /// Takes the sums of a part of the tile. A lease that begins a block does not continue what earlier blocks have
    /// seen.
    void take(const LeaseResult& part) {
        const Tile& of = part.tile;
        const PixelSums* next = part.sums.data();
        for (int y = of.y; y < of.y + of.height; ++y)
            for (int x = of.x; x < of.x + of.width; ++x) {
                PixelSums& pixel = sums[std::size_t(y - tile.y) * std::size_t(tile.width) + std::size_t(x - tile.x)];
                const std::uint32_t seen = pixel.seen;
                pixel = *next++;
                pixel.seen |= seen;
            }
        health.add(part.health);
    }
    void copyTo(const TileSums& to) const {
        for (int y = 0; y < tile.height; ++y)
            std::copy_n(sums.begin() + std::ptrdiff_t(y) * tile.width, tile.width,
                        to.pixels + std::ptrdiff_t(y) * to.stride);
        to.health->add(health);
    }

    Tile tile;
    std::vector<PixelSums> sums;
    Health health;
};

/// Returns a film of the tile with the block's samples before `next`.
Film filmOf(const Tile& tile, std::uint64_t next, std::vector<PixelSums> block) {
    TileProgress progress(tile, next - next % kSamplesPerBlock);
    progress.advance(tile, next);
    std::vector<Moments> moments(block.size());
    return {0, {std::move(progress), std::move(moments), std::move(block), Health()}};
}

}  // namespace

Result<void> takeOwnPart(Device& own, SharedWork& work, const std::stop_token& stop, const Extended& told) {
    while (const std::optional<SharedWork::OwnWork> part = work.nextOwn(stop)) {
        if (told)
            told(work.merged());
        if (!part->lease)
            continue;
        Result<LeaseResult> result = traceLease(own, *part->lease, stop);
        if (!result)
            return result.error();
        if (stop.stop_requested())
            return {};
        Result<void> taken =
            part->audit ? work.audited(*part->audit, *std::move(result)) : work.deliverOwn(*std::move(result));
        if (!taken)
            return taken;
    }
    return {};
}

Result<void> traceTogether(Device& own, SharedWork& work, std::uint64_t scene, const Tile& tile, SampleRange samples,
                           TileSums sums, const std::stop_token& stop) {
    for (;;) {
        TileCopy copy(tile, sums);
        Film film = filmOf(tile, samples.first, copy.sums);
        const auto merged = [&copy](const LeaseResult& part) { copy.take(part); };
        if (!work.begin(film, scene, {{tile, samples.first, samples.end()}}, stop, merged))
            return own.trace(tile, samples, sums, stop);
        Result<void> done = takeOwnPart(own, work, stop);
        const std::set<std::string> contributors = work.end();
        if (!done || stop.stop_requested())
            return done;
        if (!work.isAnyUntrusted(contributors)) {
            copy.copyTo(sums);
            return {};
        }
    }
}

}  // namespace pdr
