#pragma once
/// Cost of fast filtering in accuracy, and the time that it saves.

#include <cstdint>

#include "render/base/result.h"
#include "render/device/device.h"
#include "render/kernel/flat_scene.h"

namespace pdr::bench {

/// Differences between exact and fast filtering at places inside the volume [HU].
struct HuPrice {
    int places = 0;
    double rms = 0;
    double almostAll = 0;  ///< difference that 99.9 % of the places do not exceed
    double largest = 0;
    double possible = 0;  ///< largest difference that the steepest cube of eight voxels allows; see textureError()
};

/// Compares both filters at `places` random places, uniform over the box of the volume. Fast filtering is computed on
/// the host as texture units do it.
HuPrice huPrice(const FlatVolume& volume, int places, std::uint64_t seed);

/// Differences between two images from the same samples, in display levels (of 255, not rounded, exposure 1), over the
/// pixels that have noise or differ. Means are over the channels of these pixels.
struct LevelPrice {
    std::size_t pixels = 0;
    double mean = 0, largest = 0;  ///< mean and largest absolute difference
    double shift = 0;              ///< mean of fast - exact
    double offByOne = 0;           ///< fraction of the pixels that have a channel that is off by more than 1 level
    double standardError = 0;      ///< mean standard error of the exact image
};

/// Compares two films of the same size.
LevelPrice levelPrice(const Film& exact, const Film& fast);

struct ImagePrice {
    LevelPrice levels;
    double exactSeconds = 0, fastSeconds = 0;  ///< median times over the rounds, for all samples
};

/// Renders `scene` with both filters in turn, `rounds` times each, and compares them.
Result<ImagePrice> imagePrice(Device& device, const Scene& scene, std::uint32_t samples, int rounds);

}  // namespace pdr::bench
