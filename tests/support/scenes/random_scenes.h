#pragma once
/// Random scenes, and a test of whether two images are the same within their noise.

#include <algorithm>
#include <random>

#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

namespace pdr::test {

/// Returns a random unit vector, uniform over all directions.
inline dvec3 anyDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random), z = normal(random);
    return glm::normalize(dvec3(x, y, z));
}

/// Makes single voxels of bone in air, which a bound that overlooks a voxel would lose.
inline std::shared_ptr<const Volume> speckledVolume(ivec3 size, dvec3 spacing, unsigned seed) {
    std::mt19937 random(seed);
    return makeVolume(size, spacing, [&](int, int, int) { return random() % 400 ? -900 : 1900; });
}

/// Makes a random transfer function of steps, bands and ramps over the HU of these volumes; air is transparent, bone is
/// not.
inline TransferFunction anyFunction(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0, 1);
    TransferFunction function;
    function.extinctionPerMm = 0.2f + 3 * unit(random);
    float hu = -900;
    for (int i = 0; i < 7; ++i) {
        hu += random() % 3 ? 500 * unit(random) : 0;
        const float red = unit(random), green = unit(random);
        const vec3 albedo = vec3(0.3f) + 0.7f * vec3(red, green, 1 - red);
        function.nodes.push_back({.hu = hu, .opacity = random() % 3 ? unit(random) : 0, .albedo = albedo});
    }
    function.nodes.front().opacity = 0;
    function.nodes.back().opacity = 0.5f;
    return function;
}

/// Makes a random scene of rough or speckled tissue, seen and lit from anywhere, with or without each effect.
inline Scene anyScene(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto voxels = [&] { return 16 + int(random() % 40); };
    const auto spacing = [&] { return 0.5 + unit(random); };
    const ivec3 size{voxels(), voxels(), voxels()};
    const dvec3 apart{spacing(), spacing(), spacing()};
    Scene scene = plainScene(seed % 3 ? bumpyVolume(size, apart, seed) : speckledVolume(size, apart, seed), 1);
    scene.transferFunction = anyFunction(random);
    const dvec3 centre = scene.volume->geometry().centreMm();
    const double radius = scene.volume->geometry().radiusMm();
    scene.camera.fovDegrees = 20 + 30 * unit(random);
    scene.camera.targetMm = centre;
    scene.camera.eyeMm =
        centre + anyDirection(random) * (0.9 * radius / std::tan(glm::radians(scene.camera.fovDegrees) / 2));
    scene.camera.up = anyDirection(random);
    const dvec3 place = 2 * radius * anyDirection(random), ball = 2 * radius * anyDirection(random);
    scene.lights = {DirectionalLight{anyDirection(random), vec3(2, 1, 1)},
                    RectangleLight{centre + place, -place, anyDirection(random), radius, 2 * radius, vec3(3, 5, 4)},
                    SphereLight{centre + ball, radius / 2, vec3(3, 3, 6)},
                    DirectionalLight{anyDirection(random), vec3(1, 1, 3)}};
    scene.environment = {vec3(0.3f, 0.2f, 0.4f), random() % 2 == 0};
    scene.model = random() % 3 ? Model::singleScattering : Model::multipleScattering;
    scene.phaseG = float(1.2 * unit(random) - 0.6);
    scene.gradientFactor = random() % 3 ? 1 + 2 * float(unit(random)) : 0;
    scene.rayOrigin = seed % 2 ? RayOrigin::event : RayOrigin::outsideEdge;
    scene.film = {24, 24};
    scene.seed = seed;
    return scene;
}

/// Similarity of two images with independent noise.
struct Likeness {
    double p = 1;              ///< p-value of chi-square over blocks of pixels
    double relativeError = 0;  ///< standard error of the difference of the means, which is detected from about five on
};

/// Compares two images. `partner(pixel)`: the pixel of `b` that shows what `pixel` of `a` shows. Compares the luminance
/// in blocks of 4 x 4 pixels, so that means are close to normal where few samples of a pixel hit anything.
template <class Partner>
Likeness likeness(const Film& a, const Film& b, Partner&& partner) {
    constexpr int kBlock = 4;
    const auto variance = [](const PixelEstimate& pixel) {
        const double error = luminance(pixel.standardError);  // upper bound: channels share their paths
        return error * error;
    };
    double square = 0, variances = 0, total = 0;
    int freedom = 0;
    for (int y = 0; y < a.size().y; y += kBlock)
        for (int x = 0; x < a.size().x; x += kBlock) {
            double difference = 0, noise = 0;
            for (int i = 0; i < kBlock * kBlock; ++i) {
                const ivec2 pixel(x + i % kBlock, y + i / kBlock), other = partner(pixel);
                const PixelEstimate one = a.pixel(pixel.x, pixel.y), two = b.pixel(other.x, other.y);
                difference += luminance(one.mean) - luminance(two.mean);
                noise += variance(one) + variance(two);
                total += luminance(one.mean);
            }
            variances += noise;
            if (noise > 0) {
                square += difference * difference / noise;
                ++freedom;
            } else if (std::fabs(difference) > 1e-9) {
                return {0, 0};
            }
        }
    return {chiSquareP(square, freedom), std::sqrt(variances) / total};
}

inline Likeness likeness(const Film& a, const Film& b) {
    return likeness(a, b, [](ivec2 pixel) { return pixel; });
}

}  // namespace pdr::test
