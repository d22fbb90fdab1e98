#pragma once
/// Statistics of whole images, and the scene that most closed forms describe.

#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

namespace pdr::test {

/// Mean of the red channel over all pixels, and its standard error.
struct ImageMean {
    double mean = 0, standardError = 0;
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

inline bool sameBits(const Film& a, const Film& b) {
    for (int y = 0; y < a.size().y; ++y)
        for (int x = 0; x < a.size().x; ++x)
            if (a.pixel(x, y).mean != b.pixel(x, y).mean || a.pixel(x, y).standardError != b.pixel(x, y).standardError)
                return false;
    return true;
}

/// Makes a wide slab of optical depth tau, seen straight on; the film shows 1 mm at its middle.
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

/// Returns the distance of an image's mean from `truth` in standard errors.
inline double z(const Film& film, double truth) {
    const ImageMean got = imageMean(film);
    return (got.mean - truth) / got.standardError;
}

}  // namespace pdr::test
