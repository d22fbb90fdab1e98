#pragma once
/// The random numbers of one path. Those that decide most of the noise are coordinates of low-discrepancy points
/// (sobol.h): the position in the pixel and on the lens, and all numbers up to the first event and its light. All
/// others are hashed (random.h).
///   sequences   each pixel has two, scrambled independently: one for its even and one for its odd samples. The means
///               of the two halves are independent estimates even though each sequence is stratified. No other seed has
///               these sequences, neighbouring seeds included: the seed alone is mixed before pixel and half are added
///               to it
///   addressing  like all random numbers, by seed, pixel, sample, bounce and dimension

#include "render/kernel/attenuation.h"
#include "render/kernel/random.h"
#include "render/kernel/sobol.h"

namespace pdr {

/// Returns -ln(1 - x) for x = (fraction + 1/2) 2^-32: an exponentially distributed optical depth in [1.2e-10, 23]. It
/// is computed without cancellation for small x.
PDR_HD inline float freePathDepth(std::uint32_t fraction) {
    const float x = (float(fraction) + 0.5f) * 0x1p-32f;
    const float rest = (float(~fraction) + 0.5f) * 0x1p-32f;
    return x > 0.5f ? negativeLog(rest) : depthThatTakes(x);
}

class Sampler {
  public:
    Sampler() = default;
    PDR_HD Sampler(const SobolTable& points, std::uint64_t seed, std::uint32_t pixel, std::uint64_t sample)
        : random_(seed, pixel, sample),
          points_(&points),
          scramble_(mixBits(mixBits(~seed) + 2 * std::uint64_t(pixel) + sample % 2)),
          point_(std::uint32_t(sample / 2)) {}

    PDR_HD vec2 pair(Dimension dimension) const {
        const int first = dimension == Dimension::filter ? 0 : 16;
        return {number(first), number(first + 1)};
    }
    PDR_HD float number(int bounce, BounceDimension dimension) const {
        const int first = coordinateOf(dimension);
        return isCoordinate(bounce, first) ? number(first) : stream(bounce, dimension).pair().x;
    }
    PDR_HD vec2 pair(int bounce, BounceDimension dimension) const {
        const int first = coordinateOf(dimension);
        return isCoordinate(bounce, first) ? vec2(number(first), number(first + 1)) : stream(bounce, dimension).pair();
    }
    /// Returns three numbers.
    PDR_HD vec3 triple(int bounce, BounceDimension dimension) const {
        const int first = coordinateOf(dimension);
        if (isCoordinate(bounce, first))
            return {number(first), number(first + 1), number(first + 2)};
        RandomStream random = stream(bounce, dimension);
        const vec2 u = random.pair();
        return {u, random.pair().x};
    }
    /// Returns the optical depth up to event `event` of the two on the first segment. Each is distributed as if it were
    /// alone; one lies in the nearer half of the distribution and one in the further half.
    PDR_HD float depth(int event) const {
        return freePathDepth(coordinate(coordinateOf(BounceDimension::distance)) ^ (std::uint32_t(event) << 31));
    }

    /// Returns a stream of hashed numbers.
    PDR_HD RandomStream stream(int bounce, BounceDimension dimension) const {
        return random_.stream(bounce + (branch_ << 24), dimension);
    }

    /// Returns the sampler of event `i` of `count` on the first segment, which uses the next points of a denser
    /// sequence.
    PDR_HD Sampler branch(int i, int count) const {
        Sampler branch = *this;
        branch.point_ = point_ * std::uint32_t(count) + std::uint32_t(i);
        branch.branch_ = i;
        return branch;
    }

  private:
    /// Returns the first coordinate that a dimension of the first event uses; -1: its numbers are hashed. Lower
    /// coordinates are more evenly distributed jointly.
    PDR_HD static constexpr int coordinateOf(BounceDimension dimension) {
        switch (dimension) {
            case BounceDimension::distance:
                return 2;
            case BounceDimension::light:
                return 3;
            case BounceDimension::choice:
                return 5;
            case BounceDimension::shadow:
                return 6;
            case BounceDimension::event:
                return 7;
            case BounceDimension::direction:
                return 8;
            case BounceDimension::environment:
                return 11;
            case BounceDimension::continuation:
                return 13;
            case BounceDimension::roulette:
            case BounceDimension::looks:
            case BounceDimension::lightLooks:
                return -1;
        }
        return -1;
    }

    /// Returns whether a number is a coordinate of a point: only numbers of the first event are.
    PDR_HD static constexpr bool isCoordinate(int bounce, int first) { return bounce == 0 && first >= 0; }

    PDR_HD std::uint32_t coordinate(int dimension) const {
        std::uint64_t seed = (scramble_ + std::uint64_t(dimension)) * 0x9E3779B97F4A7C15ull;
        seed = (seed ^ (seed >> 32)) * 0xD6E8FEB86659FD93ull;
        return owenScrambled(sobolCoordinate(*points_, dimension, point_), std::uint32_t(seed >> 32));
    }
    /// Returns a coordinate of the point, in [2^-24, 1 - 2^-24].
    PDR_HD float number(int dimension) const { return (float(coordinate(dimension) >> 9) + 0.5f) * 0x1p-23f; }

    Random random_;
    const SobolTable* points_;
    std::uint64_t scramble_;
    std::uint32_t point_;
    int branch_ = 0;
};

}  // namespace pdr
