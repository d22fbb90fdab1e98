#pragma once
/// The unit of work: a lease requests samples of a tile from a device or worker, and a result returns them.

#include <cstdint>
#include <vector>

#include "render/base/lease_limits.h"
#include "render/film/film.h"

namespace pdr {

/// Identifies what renders: this program's own device, or a worker.
using WorkerId = std::uint32_t;
inline constexpr WorkerId kOwnDevice = 0;

/// A part of a request that is rendered at a time.
struct Portion {
    std::uint64_t number = 0;
    Tile tile;
    SampleRange samples;  ///< samples of one block, or of several whole ones
};

/// A portion as it is given to a renderer, with what it continues.
struct Lease {
    std::uint64_t number = 0;  ///< unique
    std::uint64_t scene = 0;   ///< number of the published scene
    Tile tile;
    SampleRange samples;            ///< samples of one block, or of several whole ones
    std::vector<PixelSums> before;  ///< sums of the block's earlier samples, row by row; empty: there are none
    std::vector<Moments> moments;   ///< if deep: moments of the film's earlier samples; empty: there are none
    bool isKept = false;            ///< the worker probably still has these sums or moments
};

/// The rendered samples of a lease.
struct LeaseResult {
    std::uint64_t number = 0;
    Tile tile;
    SampleRange samples;
    std::vector<PixelSums> sums;  ///< sums of the block, from its start to samples.end(), row by row; if deep: only the
                                  ///< `seen` bits
    Health health;                ///< faults of the lease's samples
    double seconds = 0;           ///< time spent on the lease's samples
    std::vector<Moments> moments;  ///< if deep: moments of the film's samples before samples.end()
};

/// Returns the range from the start of the block to the end of `samples`, as Film::merge() takes it.
inline SampleRange fromBlockStart(SampleRange samples) {
    const std::uint64_t start = samples.first - samples.first % kSamplesPerBlock;
    return {start, std::uint32_t(samples.end() - start)};
}

/// Returns the work: samples times pixels.
inline double workOf(const Tile& tile, SampleRange samples) {
    return double(pixelCount(tile)) * samples.count;
}

}  // namespace pdr
