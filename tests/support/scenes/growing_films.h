#pragma once
/// Films of a scene before and after an edit, whose noise is the same where the edit changes no path.

#include <cmath>
#include <memory>

#include "render/edit/kept_image.h"
#include "tests/support/scenes/noisy_films.h"

namespace pdr::test {

/// Discs on a grid before a ground that is brighter on one side.
inline double discs(int x, int y) {
    const double ground = 0.1 + 0.002 * x;
    return std::hypot(x % 32 - 16, y % 32 - 16) < 8 ? 5 * ground : ground;
}

/// The discs after an edit: light that has changed slowly over the image, by a fifth at most.
inline double edited(int x, int y) {
    return discs(x, y) * (1 + 0.2 * std::sin(x / 25.0) * std::cos(y / 20.0));
}

/// A film that grows, and its first samples.
struct Growing {
    Truth truth;
    std::uint64_t seed;
    /// Part of the noise that is not that of the other films of this seed: an edit changes some paths.
    double own = 0;
    ivec2 size{160, 128};
    Film film{size, 1};
    FirstSamples first{};

    Growing& to(std::uint64_t samples) {
        while (film.samplesPerPixel() < samples) {
            const std::uint64_t had = film.samplesPerPixel(), left = FirstSamples::leftToMark(had);
            grow(
                film, std::min(samples, left < samples - had ? had + left : samples),
                [&](std::size_t pixel, std::uint64_t sample) { return value(pixel, sample); },
                [](std::size_t) { return kSeenTissue | kSeenChance; });
            first.keep(film);
        }
        return *this;
    }
    double value(std::size_t pixel, std::uint64_t sample) const {
        const bool other = chance(seed + 77, pixel, sample) < own;
        return truth(int(pixel) % size.x, int(pixel) / size.x) *
               -std::log1p(-chance(other ? seed + 1000 : seed, pixel, sample));
    }
};

/// Returns a guide, twice as fine as a film of `size` pixels, that shows the truth in parts of its own unit.
inline denoise::Guide guideOf(const Truth& truth, ivec2 size) {
    constexpr int kFiner = 2;
    denoise::Guide guide = denoise::guideOf(size, kFiner);
    for (denoise::Plane& plane : guide.radiance)
        for (int y = 0; y < plane.size().y; ++y)
            for (int x = 0; x < plane.size().x; ++x)
                plane.row(y)[x] = 7 * float(truth(x / kFiner, y / kFiner));
    return guide;
}

inline std::shared_ptr<const KeptImage> kept(const Growing& growing) {
    const NoisyFilm noisy = noisyFilm(growing.film);
    return keptImage(noisy, denoisedHalves(noisy, {}), growing.film.samplesPerPixel(), growing.first);
}

}  // namespace pdr::test
