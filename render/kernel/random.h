#pragma once
/// Random numbers that are addressed, not consumed: each is a function of (seed, pixel, sample, dimension, index). The
/// order of work, tiles, threads, machines and effects that are left out do not change the other numbers.
///   Random        one path: keys made from seed, pixel and sample
///   RandomStream  one dimension of a path, as a sequence; numbers lie in [2^-24, 1 - 2^-24], never 0 or 1
/// The generator is SplitMix64's finaliser (Steele, Lea & Flood 2014; constants: Stafford's variant 13) over a counter,
/// with a second key mixed in halfway, so that no two streams can run into each other.

#include <cstdint>

#include "render/base/lanes.h"

namespace pdr {

/// Purpose of a random number. The values are fixed: a new effect gets a new value, none is ever reused.
enum class Dimension : std::uint32_t {
    filter = 0,  ///< position in the pixel
    lens = 1,
    bounce = 16,  ///< + kDimensionsPerBounce * bounce + a BounceDimension
};
inline constexpr std::uint32_t kDimensionsPerBounce = 16;
enum class BounceDimension : std::uint32_t {
    distance = 0,
    event = 1,
    light = 2,
    shadow = 3,
    direction = 4,
    roulette = 5,
    continuation = 6,
    environment = 7,
    choice = 8,
    looks = 9,        ///< places at which the first flight looks at thin tissue
    lightLooks = 10,  ///< places at which the flights to the lights look
};

PDR_HD inline std::uint64_t mixBits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
    return x ^ (x >> 31);
}

/// The stream of one dimension, for one path (Real = float) or for several in lanes.
template <class Real>
struct RandomStreamOf {
    using Bits = typename SimdTraits<Real>::Bits;
    using Mask = typename SimdTraits<Real>::Mask;

    Bits counter, key;

    /// Draws the next two numbers where `mask` holds; the streams of other lanes do not advance.
    PDR_HD void pair(Mask mask, Real& first, Real& second) {
        counter += masked(mask, Bits{} + 0x9E3779B97F4A7C15ull);
        Bits x = (counter ^ (counter >> 30)) * 0xBF58476D1CE4E5B9ull;
        x = (x ^ (x >> 27) ^ key) * 0x94D049BB133111EBull;
        x ^= x >> 31;
        // The open interval: (k + 1/2) 2^-23 for 23 bits k, exact in float.
        first = (toFloat(highBits(x)) + 0.5f) * 0x1p-23f;
        second = (toFloat(lowBits(x)) + 0.5f) * 0x1p-23f;
    }
};

struct RandomStream : RandomStreamOf<float> {
    PDR_HD vec2 pair() {
        vec2 u;
        RandomStreamOf<float>::pair(true, u.x, u.y);
        return u;
    }
};

class Random {
  public:
    Random() = default;
    PDR_HD Random(std::uint64_t seed, std::uint32_t pixel, std::uint64_t sample)
        : low_(mixBits(seed + 0x9E3779B97F4A7C15ull * (sample + 1))), high_(mixBits(low_ + pixel)) {}

    PDR_HD RandomStream stream(Dimension dimension) const { return stream(std::uint32_t(dimension)); }
    PDR_HD RandomStream stream(int bounce, BounceDimension dimension) const {
        return stream(std::uint32_t(Dimension::bounce) + kDimensionsPerBounce * std::uint32_t(bounce) +
                      std::uint32_t(dimension));
    }

  private:
    PDR_HD RandomStream stream(std::uint32_t dimension) const {
        return {{mixBits(high_ + dimension), high_ ^ (low_ << 1)}};
    }

    std::uint64_t low_, high_;
};

}  // namespace pdr
