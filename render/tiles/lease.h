#pragma once
/// What a worker is asked for and what it answers: samples of a tile, the unit of work that can be anybody's.

#include <cstdint>
#include <vector>

#include "render/film/film.h"

namespace pdr {

/// Who takes samples: this program's own device, or a worker that has joined it.
using WorkerId = std::uint32_t;
inline constexpr WorkerId kOwnDevice = 0;

/// Of an order, what one takes at a time.
struct Portion {
    std::uint64_t number = 0;
    Tile tile;
    SampleRange samples;  ///< in one block
};

struct Lease {
    std::uint64_t number = 0;  ///< of this lease alone
    std::uint64_t scene = 0;   ///< the number that it was published under
    Tile tile;
    SampleRange samples;            ///< in one block
    std::vector<PixelSums> before;  ///< of the block's samples before those, row by row; empty: there are none
};

struct LeaseResult {
    std::uint64_t number = 0;
    Tile tile;
    SampleRange samples;
    std::vector<PixelSums> sums;  ///< of the block up to samples.end(), row by row
    Health health;                ///< of the lease's samples
    double seconds = 0;           ///< spent on them
};

/// The samples of the block up to the end of `samples`: those that a film's merge() is told of.
inline SampleRange fromBlockStart(SampleRange samples) {
    const std::uint64_t start = samples.first - samples.first % kSamplesPerBlock;
    return {start, std::uint32_t(samples.end() - start)};
}

/// Pixels of a lease, at most: what a worker has to hold and to send at a time.
inline constexpr int kMostLeasePixels = 512 * 512;

/// Samples times pixels: what work is measured in.
inline double workOf(const Tile& tile, SampleRange samples) {
    return double(tile.width) * tile.height * samples.count;
}

}  // namespace pdr
