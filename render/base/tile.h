#pragma once
/// Tiles of the image, ranges of samples, and the sums to which a device adds the samples.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "render/base/health.h"
#include "render/base/portable.h"

namespace pdr {

/// A rectangle of pixels [x, x + width) x [y, y + height) inside the image; y points down.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Tile&) const = default;
};

/// Returns the tile of all pixels of an image of `size`.
inline Tile wholeImage(ivec2 size) {
    return {0, 0, size.x, size.y};
}

/// Returns whether all pixels of `inner` are in `outer`.
inline bool isInside(const Tile& inner, const Tile& outer) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.width >= 0 && inner.height >= 0 &&
           inner.x + inner.width <= outer.x + outer.width && inner.y + inner.height <= outer.y + outer.height;
}

/// Returns the pixels that both have: a tile of no width or height where there are none.
inline Tile intersection(const Tile& a, const Tile& b) {
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    const int right = std::min(a.x + a.width, b.x + b.width), below = std::min(a.y + a.height, b.y + b.height);
    return {x, y, std::max(right - x, 0), std::max(below - y, 0)};
}

/// Returns the number of pixels in `tile`.
inline std::size_t pixelCount(const Tile& tile) {
    return std::size_t(tile.width) * std::size_t(tile.height);
}

/// Samples [first, first + count) of every pixel. A range never crosses a multiple of kSamplesPerBlock.
struct SampleRange {
    std::uint64_t first = 0;
    std::uint32_t count = 0;

    std::uint64_t end() const { return first + count; }
    bool operator==(const SampleRange&) const = default;
};

/// Number of samples in a block. Samples are summed in blocks, then merged into the film's mean and variance: the block
/// keeps the sum exact enough for 1e7 iterations, and its fixed place in the sequence makes the image independent of
/// how the work was divided.
inline constexpr std::uint32_t kSamplesPerBlock = 64;

/// Returns the range of at most `wanted` samples from `first` on that ends before the next block.
inline SampleRange samplesInBlock(std::uint64_t first, std::uint32_t wanted) {
    return {first, std::min(wanted, kSamplesPerBlock - std::uint32_t(first % kSamplesPerBlock))};
}

/// Bits of PixelSums::seen: what the samples of a pixel have met so far.
inline constexpr std::uint32_t kSeenTissue = 1;  ///< a sample met tissue
inline constexpr std::uint32_t kSeenChance = 2;  ///< samples meet light by chance: one without may be unlucky

/// Number of groups of a pixel's samples, and the bit of the first group: sample n belongs to group n mod kSeenGroups,
/// and a bit of PixelSums::seen for each group, beyond those above, records that one of its samples met tissue. Tissue
/// that few groups have met has probably been missed in other pixels. The number is odd, so that a group's samples are
/// spread over the strata of the sampler's points.
inline constexpr std::uint32_t kSeenGroups = 13, kFirstGroupBit = 2;
/// Returns the bits of PixelSums::seen that sample number `sample` sets if it meets tissue.
PDR_HD inline std::uint32_t seenOfTissue(std::uint64_t sample) {
    return kSeenTissue | (1u << (kFirstGroupBit + std::uint32_t(sample % kSeenGroups)));
}

/// Sums of the samples of one pixel in the current block; linear Rec. 709. Samples are added in order.
struct PixelSums {
    dvec3 sum{0.0};
    dvec3 sumOfSquares{0.0};
    vec3 evenSum{0.0f};           ///< sum of the samples with even numbers only: one of two halves
    std::uint32_t evenCount = 0;  ///< number of these samples
    std::uint32_t count = 0;      ///< samples added, without those that were no valid radiance
    std::uint32_t seen = 0;       ///< kSeen... bits of all blocks
};

/// A view of the sums of a tile: pixel (x, y) of the image is at (y - tile.y) * stride + (x - tile.x). `health` is that
/// of the whole image; null if it is not requested.
struct TileSums {
    PixelSums* pixels = nullptr;
    int stride = 0;
    Health* health = nullptr;
};

}  // namespace pdr
