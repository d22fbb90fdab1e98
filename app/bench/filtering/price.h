#pragma once
/// What fast filtering costs in accuracy, and what it saves in time.

#include <cstdint>

#include "render/base/result.h"
#include "render/device/device.h"
#include "render/kernel/flat_scene.h"

namespace pdr::bench {

/// Differences between exact and fast filtering at places inside the volume [HU].
struct HuPrice {
    int places = 0;
    double rms = 0;
    double almostAll = 0;  ///< 99.9 % of the places differ by no more
    double largest = 0;
    double possible = 0;  ///< the largest that the volume's steepest cube of eight voxels allows; see textureError()
};

/// At that many `places`, drawn evenly over the volume's box; `fast` is computed on the host as texture units do.
HuPrice huPrice(const FlatVolume& volume, int places, std::uint64_t seed);

/// Differences between two pictures from the same samples, in display levels (of 255, not rounded, exposure 1), over
/// the pixels that have noise or differ; a pixel counts by its channels.
struct LevelPrice {
    std::size_t pixels = 0;
    double mean = 0, largest = 0;  ///< of the absolute difference
    double shift = 0;              ///< mean of fast - exact
    double offByOne = 0;           ///< fraction of the pixels of which a channel is off by more than 1 level
    double standardError = 0;      ///< mean of the exact picture's
};

/// Films of one size.
LevelPrice levelPrice(const Film& exact, const Film& fast);

struct PicturePrice {
    LevelPrice levels;
    double exactSeconds = 0, fastSeconds = 0;  ///< medians over the rounds, for all samples
};

/// Renders `scene` both ways in turns, `rounds` times each.
Result<PicturePrice> picturePrice(Device& device, const Scene& scene, std::uint32_t samples, int rounds);

}  // namespace pdr::bench
