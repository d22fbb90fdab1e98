#pragma once
/// A film of one pixel with given samples.

#include <algorithm>

#include "render/film/film.h"
#include "render/kernel/pixel.h"

namespace pdr::test {

inline constexpr Tile kOnePixel{0, 0, 1, 1};

/// Makes a film with `count` samples value(i), n per iteration.
template <class Value>
Film filmOf(std::uint64_t count, Value&& value, std::uint32_t n = 64) {
    Film film(ivec2(1, 1), 0);
    while (film.samplesPerPixel() < count) {
        const SampleRange range =
            film.nextSamples(std::uint32_t(std::min<std::uint64_t>(n, count - film.samplesPerPixel())));
        const TileSums sums = film.sums(kOnePixel);
        for (std::uint64_t sample = range.first; sample < range.first + range.count; ++sample) {
            const vec3 radiance(float(value(sample)));
            if (!addSample(*sums.pixels, radiance, sample))
                sums.health->add(faultOf(radiance), sample, 0);
        }
        film.commit(range);
    }
    return film;
}

}  // namespace pdr::test
