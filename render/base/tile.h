#pragma once
/// A piece of the image, a range of samples, and the sums that a device adds them to.

#include <algorithm>
#include <cstdint>
#include <span>

#include "render/base/health.h"
#include "render/base/portable.h"

namespace pdr {

/// Pixels [x, x + width) x [y, y + height) of the image; y down. Inside the image.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Tile&) const = default;
};

/// All pixels of an image of `size`.
inline Tile wholeImage(ivec2 size) {
    return {0, 0, size.x, size.y};
}

/// Whether all pixels of `inner` are `outer`'s.
inline bool isInside(const Tile& inner, const Tile& outer) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.width >= 0 && inner.height >= 0 &&
           inner.x + inner.width <= outer.x + outer.width && inner.y + inner.height <= outer.y + outer.height;
}

/// Samples [first, first + count) of every pixel. Never crosses a multiple of kSamplesPerBlock.
struct SampleRange {
    std::uint64_t first = 0;
    std::uint32_t count = 0;

    std::uint64_t end() const { return first + count; }
    bool operator==(const SampleRange&) const = default;
};

/// Samples are summed in blocks of this many, then merged into the film's mean and variance: the block keeps the sum
/// exact enough for 1e7 iterations, and its fixed place in the sequence keeps the image independent of how the work was
/// cut.
inline constexpr std::uint32_t kSamplesPerBlock = 64;

/// At most `wanted` samples from `first` on, none of them in the next block.
inline SampleRange samplesInBlock(std::uint64_t first, std::uint32_t wanted) {
    return {first, std::min(wanted, kSamplesPerBlock - std::uint32_t(first % kSamplesPerBlock))};
}

/// What the samples of a pixel have met so far, bit by bit.
inline constexpr std::uint32_t kSeenTissue = 1;  ///< one of them met tissue
inline constexpr std::uint32_t kSeenChance = 2;  ///< they may meet light by chance: one without may only be unlucky

/// The samples of a pixel are counted in so many groups, sample n in n mod kSeenGroups: a bit beyond those above tells that
/// one of the group met tissue. Tissue that few groups have met is likely to have been missed in other pixels. An odd
/// number, so that a group's samples are spread over the strata of the sampler's points.
inline constexpr std::uint32_t kSeenGroups = 13, kFirstGroupBit = 2;
/// What a sample of that number tells its pixel if it met tissue.
PDR_HD inline std::uint32_t seenOfTissue(std::uint64_t sample) {
    return kSeenTissue | (1u << (kFirstGroupBit + std::uint32_t(sample % kSeenGroups)));
}

/// Sums of the samples of one pixel in the running block; linear Rec. 709. Samples are added in order.
struct PixelSums {
    dvec3 sum{0.0};
    dvec3 sumOfSquares{0.0};
    vec3 evenSum{0.0f};           ///< of the samples with even numbers alone: one of two halves
    std::uint32_t evenCount = 0;  ///< of these
    std::uint32_t count = 0;      ///< samples added; those that were no radiance are left out
    std::uint32_t seen = 0;       ///< kSeen... of all blocks
};

/// A view of the sums of a tile: pixel (x, y) of the image is at (y - tile.y) * stride + (x - tile.x). `health` is
/// that of the whole image; null: nobody wants to know.
struct TileSums {
    PixelSums* pixels = nullptr;
    int stride = 0;
    Health* health = nullptr;
};

}  // namespace pdr
