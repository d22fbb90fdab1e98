#pragma once
/// The mean and the variance of one pixel, merged block by block. The same arithmetic on every device.

#include <cmath>
#include <cstdint>

#include "render/base/tile.h"

namespace pdr {

struct Moments {
    dvec3 mean{0.0};
    dvec3 m2{0.0};  ///< sum of squared deviations from the mean
    std::uint64_t count = 0;
    vec3 evenMean{0.0f};  ///< mean of the samples with even numbers alone
    std::uint32_t evenCount = 0;
};

/// Returns a * b + c, rounded once.
PDR_HD inline dvec3 fused(dvec3 a, dvec3 b, dvec3 c) {
    return {std::fma(a.x, b.x, c.x), std::fma(a.y, b.y, c.y), std::fma(a.z, b.z, c.z)};
}

/// Returns the moments of two sets from the moments of each. Chan, Golub & LeVeque 1979.
PDR_HD inline Moments merged(const Moments& moments, const PixelSums& block) {
    Moments result = moments;
    if (block.count == 0)
        return result;
    const double n = block.count;
    const dvec3 blockMean = block.sum / n;
    // Nearly all of this cancels for a large value with little noise: rounded once, not twice.
    const dvec3 blockM2 = glm::max(fused(-block.sum, blockMean, block.sumOfSquares), dvec3(0.0));
    const double total = double(moments.count) + n;
    const dvec3 delta = blockMean - moments.mean;
    result.mean += delta * (n / total);
    result.m2 += blockM2 + delta * delta * (double(moments.count) * n / total);
    result.count += block.count;
    if (block.evenCount > 0) {
        result.evenCount += block.evenCount;
        const vec3 evens = block.evenSum / float(block.evenCount);
        result.evenMean += (evens - moments.evenMean) * (float(block.evenCount) / float(result.evenCount));
    }
    return result;
}

/// The two half buffers: independent means of the samples with even and with odd numbers; the mean of all where a half
/// has no sample yet. The even mean has single precision, since the halves serve only to estimate noise.
struct HalfMeans {
    dvec3 even{0.0}, odd{0.0};
};
PDR_HD inline HalfMeans halvesOf(const Moments& moments) {
    const std::uint64_t odd = moments.count - moments.evenCount;
    const dvec3 even = moments.evenCount > 0 ? dvec3(moments.evenMean) : moments.mean;
    if (odd == 0)
        return {even, moments.mean};
    return {even, moments.mean + (moments.mean - even) * (double(moments.evenCount) / double(odd))};
}

/// Returns the block after a full one: empty, but the `seen` bits stay.
PDR_HD inline PixelSums nextBlock(const PixelSums& full) {
    return {.seen = full.seen};
}

/// Returns one draw from the distribution of the mean's error: half the difference of the two halves. For independent
/// halves the mean and half the difference have the same variance, even if the samples within a half are correlated
/// (Owen 1997, "Monte Carlo variance of scrambled net quadrature", section 5: replicates). One draw says nothing about
/// its pixel; those of many pixels show how far these are off. 0 below 2 samples, and where all samples were alike.
PDR_HD inline dvec3 errorDrawOf(const Moments& moments) {
    const double odd = double(moments.count - moments.evenCount), even = double(moments.evenCount);
    if (odd == 0 || even == 0)
        return dvec3(0.0);
    const HalfMeans halves = halvesOf(moments);
    const dvec3 draw = (halves.even - halves.odd) * (std::sqrt(even * odd) / (even + odd));
    return {moments.m2.x > 0 ? draw.x : 0, moments.m2.y > 0 ? draw.y : 0, moments.m2.z > 0 ? draw.z : 0};
}

/// Returns the standard error of the mean as if samples were independent; for low-discrepancy points the real one is
/// less. 0 below 2 samples.
PDR_HD inline dvec3 standardErrorOf(const Moments& moments) {
    if (moments.count < 2)
        return dvec3(0.0);
    return glm::sqrt(moments.m2 / (double(moments.count) * double(moments.count - 1)));
}

/// Returns the Rec. 709 luminance.
PDR_HD inline double luminance(dvec3 rgb) {
    return glm::dot(rgb, dvec3(0.2126, 0.7152, 0.0722));
}

}  // namespace pdr
