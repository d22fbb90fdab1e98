#include "app/selftest/measure.h"

#include <algorithm>
#include <cmath>

#include "app/selftest/scene.h"
#include "render/base/errors.h"
#include "render/film/film.h"
#include "render/kernel/random.h"
#include "render/kernel/transport/phase.h"
#include "render/scene/scene.h"

namespace pdr::selftest {

namespace {

constexpr double kPiExact = 3.14159265358979323846;
constexpr std::uint32_t kSamplesPerLaunch = 16;  ///< few, so that Ctrl-C is noticed soon

/// Returns the mean over an image and its standard error. The pixels are independent, and so are the draws of their
/// errors.
Measurement imageMean(const Film& film) {
    Measurement result;
    double squares = 0;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x) {
            const PixelEstimate pixel = film.pixel(x, y);
            result.value += pixel.mean.x;
            squares += pixel.errorDraw.x * pixel.errorDraw.x;
        }
    const double pixels = double(film.size().x) * film.size().y;
    result.value /= pixels;
    result.standardError = std::sqrt(squares) / pixels;
    result.health = film.status().health;
    return result;
}

/// Returns the samples per pixel, at least 2, that give at least `samples` in all.
std::uint64_t samplesPerPixel(const Scene& scene, std::uint64_t samples) {
    const std::uint64_t pixels = std::uint64_t(scene.film.x) * scene.film.y;
    return std::max<std::uint64_t>(2, (samples + pixels - 1) / pixels);
}

Result<Measurement> rendered(Device& device, const Scene& scene, std::uint64_t samples, const Cancelled& cancelled) {
    if (auto ok = scene.check(); !ok)
        return ok.error();
    const auto live = startFilm(device, scene);
    if (!live)
        return live.error();
    for (std::uint64_t left = samplesPerPixel(scene, samples); left > 0;) {
        if (cancelled())
            return pdr::cancelled();
        const std::uint32_t n = std::uint32_t(std::min<std::uint64_t>(left, kSamplesPerLaunch));
        if (auto ok = (*live)->accumulate(n, {}); !ok)
            return ok.error();
        left -= n;
    }
    const auto film = (*live)->film();
    if (!film)
        return film.error();
    return imageMean(**film);
}

/// Converts the mean of the image to the quantity of the case by an affine map.
Measurement converted(const Case& reference, Measurement radiance) {
    const CaseScene& scene = reference.scene;
    double factor = 1, offset = 0;
    if (reference.quantity == Quantity::reflectanceFactor)
        factor = kPiExact / std::fabs(scene.beam.value_or(1));
    if (reference.quantity == Quantity::discTransmittance) {  // outside the disc the image shows the environment
        factor = kDiscWidth * kDiscWidth / kPiExact / scene.room;
        offset = 1 - factor * scene.room;
    }
    if (reference.quantity == Quantity::escapeProbability)  // flux out of the surface over what the sphere emits
        factor = kDiscWidth * kDiscWidth / kPiExact * 3 / (4 * scene.depth * scene.emission);
    radiance.value = factor * radiance.value + offset;
    radiance.standardError *= factor;
    return radiance;
}

/// Renders an image of its own for each bin, so that the counts are independent: chi-square has kFlightBins degrees of
/// freedom.
Result<Measurement> freeFlights(Device& device, const Case& reference, std::uint64_t samples, std::uint64_t seed,
                                const Cancelled& cancelled) {
    Measurement result;
    const double p = 1.0 / kFlightBins;
    for (int bin = 0; bin < kFlightBins; ++bin) {
        Scene scene = flightScene(reference, bin);
        scene.seed = seed + std::uint64_t(bin);
        const Result<Measurement> fraction = rendered(device, scene, samples, cancelled);
        if (!fraction)
            return fraction.error();
        const double z = (fraction->value - p) / fraction->standardError;
        result.value += z * z;
        result.health.add(fraction->health);
    }
    result.standardError = std::sqrt(2.0 * kFlightBins);
    return result;
}

Measurement phaseMoment(const Case& reference, std::uint64_t samples, std::uint64_t seed) {
    const vec3 forward = glm::normalize(vec3(0.3f, -0.5f, 0.7f));
    const bool squared = reference.quantity == Quantity::meanSquaredCosine;
    double sum = 0, squares = 0;
    for (std::uint64_t i = 0; i < samples; ++i) {
        const vec2 u = Random(seed, std::uint32_t(i), i >> 32).stream(0, BounceDimension::direction).pair();
        const vec3 scattered = phaseSample(float(reference.scene.g), -forward, u);
        const double cosine = glm::dot(dvec3(scattered), dvec3(forward));
        const double value = (squared ? cosine * cosine : cosine) - reference.expected;
        sum += value;
        squares += value * value;
    }
    const double n = double(samples), mean = sum / n;
    return {reference.expected + mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1))};
}

}  // namespace

Result<Measurement> measure(Device& device, const Case& reference, std::uint64_t samples, std::uint64_t seed,
                            const Cancelled& cancelled) {
    if (reference.quantity == Quantity::freeFlights)
        return freeFlights(device, reference, samples, seed, cancelled);
    if (reference.quantity == Quantity::meanCosine || reference.quantity == Quantity::meanSquaredCosine)
        return phaseMoment(reference, samples, seed);
    Scene scene = sceneOf(reference);
    scene.seed = seed;
    const Result<Measurement> radiance = rendered(device, scene, samples, cancelled);
    return radiance ? Result<Measurement>(converted(reference, *radiance)) : radiance;
}

}  // namespace pdr::selftest
