#pragma once
/// The unit of work: samples of a tile, for whoever renders them, and the result.

#include <cstdint>
#include <vector>

#include "render/film/film.h"

namespace pdr {

/// Whoever renders: this program's own device, or a worker.
using WorkerId = std::uint32_t;
inline constexpr WorkerId kOwnDevice = 0;

/// A part of an order that is rendered at a time.
struct Portion {
    std::uint64_t number = 0;
    Tile tile;
    SampleRange samples;  ///< in one block
};

struct Lease {
    std::uint64_t number = 0;  ///< unique
    std::uint64_t scene = 0;   ///< number of the published scene
    Tile tile;
    SampleRange samples;            ///< in one block
    std::vector<PixelSums> before;  ///< sums of the block's earlier samples, row by row; empty: there are none
};

struct LeaseResult {
    std::uint64_t number = 0;
    Tile tile;
    SampleRange samples;
    std::vector<PixelSums> sums;  ///< of the block, from its start to samples.end(), row by row
    Health health;                ///< of the lease's samples
    double seconds = 0;           ///< spent on them
};

/// From the start of the block to the end of `samples`: what a film's merge() takes.
inline SampleRange fromBlockStart(SampleRange samples) {
    const std::uint64_t start = samples.first - samples.first % kSamplesPerBlock;
    return {start, std::uint32_t(samples.end() - start)};
}

/// Limit on the pixels of a lease, and so on the memory and the message of its result.
inline constexpr int kMostLeasePixels = 512 * 512;

/// Work: samples times pixels.
inline double workOf(const Tile& tile, SampleRange samples) {
    return double(tile.width) * tile.height * samples.count;
}

}  // namespace pdr
