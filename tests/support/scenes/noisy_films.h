#pragma once
/// Films with known means and noise like that of a renderer: skewed, and proportional to the radiance.

#include <functional>

#include "render/film/error/noisy_film.h"
#include "tests/support/scenes/known_films.h"

namespace pdr::test {

/// A grey image: returns the radiance at (x, y).
using Truth = std::function<double(int x, int y)>;

/// Returns a number that is uniformly distributed in [0, 1).
inline double chance(std::uint64_t seed, std::size_t pixel, std::uint64_t sample) {
    std::uint64_t bits = (seed * 0x9e3779b97f4a7c15u + pixel) * 0xbf58476d1ce4e5b9u + sample;
    for (const int shift : {30, 27, 31})
        bits = (bits ^ (bits >> shift)) * 0x94d049bb133111ebu;
    return double(bits >> 11) * 0x1p-53;
}

/// Makes a film whose samples are exponentially distributed about the truth, with a standard deviation of `sigma` in
/// [0, 1] times the truth.
inline Film noisyFilmOf(ivec2 size, const Truth& truth, std::uint64_t samples, double sigma = 1,
                        std::uint64_t seed = 1) {
    Film film(size, 1);
    const auto value = [&](std::size_t pixel, std::uint64_t sample) {
        const double mean = truth(int(pixel) % size.x, int(pixel) / size.x);
        return mean * (1 + sigma * (-std::log1p(-chance(seed, pixel, sample)) - 1));
    };
    grow(film, samples, value, [](std::size_t) { return kSeenTissue | kSeenChance; });
    return film;
}

/// Returns the denoised radiance of a grey film, linear, row by row: its red channel, which stands for all three.
inline std::vector<double> smoothRadiance(const Film& film) {
    const NoisyFilm noisy = noisyFilm(film);
    const denoise::Colours colours = pdr::smoothRadiance(noisy);
    std::vector<double> radiance;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x)
            radiance.push_back(noisy.unit * double(colours[0].row(y)[x]));
    return radiance;
}

}  // namespace pdr::test
