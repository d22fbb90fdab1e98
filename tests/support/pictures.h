#pragma once
/// What pictures and single pixels say as a whole, and the slab whose closed forms are known.

#include <cmath>

#include "render/kernel/pixel.h"
#include "tests/support/scenes.h"

namespace pdr::test {

/// Mean over pixels of the red channel, and its standard error.
struct ImageMean {
    double mean = 0, standardError = 0;

    double z(double truth) const { return (mean - truth) / standardError; }
};

inline ImageMean imageMean(const Film& film) {
    ImageMean result;
    double squares = 0;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x) {
            const PixelEstimate pixel = film.pixel(x, y);
            result.mean += pixel.mean.x;
            squares += pixel.standardError.x * pixel.standardError.x;
        }
    const double pixels = double(film.size().x) * film.size().y;
    return {result.mean / pixels, std::sqrt(squares) / pixels};
}

/// Whether two films hold the same numbers, bit by bit.
inline bool sameBits(const Film& a, const Film& b) {
    for (int y = 0; y < a.size().y; ++y)
        for (int x = 0; x < a.size().x; ++x)
            if (a.pixel(x, y).mean != b.pixel(x, y).mean || a.pixel(x, y).standardError != b.pixel(x, y).standardError)
                return false;
    return true;
}

inline constexpr Tile kOnePixel{0, 0, 1, 1};

/// A film of one pixel after `count` samples value(i), n to an iteration.
template <class Value>
Film filmOf(std::uint64_t count, Value&& value, std::uint32_t n = 64) {
    Film film({1, 1}, 0);
    while (film.samplesPerPixel() < count) {
        const SampleRange range =
            film.nextSamples(std::uint32_t(std::min<std::uint64_t>(n, count - film.samplesPerPixel())));
        for (std::uint32_t i = 0; i < range.count; ++i)
            addSample(*film.sums(kOnePixel).pixels, vec3(float(value(range.first + i))));
        film.commit(range);
    }
    return film;
}

/// A wide slab of depth tau, 10 mm thick, seen straight on: every pixel looks at its middle. Lit by parallel light of
/// irradiance 2.
inline Scene slab(double tau, dvec3 lightTravels, float albedo) {
    const double thickness = 10;
    Scene scene = plainScene(makeVolume({401, 401, 5}, {1, 1, thickness / 5}, [](int, int, int) { return 0; }),
                             float(tau / thickness));
    scene.transferFunction.nodes[0].albedo = vec3(albedo);
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = {200.5, 200.5, 500},
                    .targetMm = {200.5, 200.5, 0},
                    .up = {0, 1, 0},
                    .heightMm = 1};
    scene.lights = {DirectionalLight{lightTravels, vec3(2)}};
    scene.film = {4, 4};
    return scene;
}

}  // namespace pdr::test
