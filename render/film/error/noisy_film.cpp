#include "render/film/error/noisy_film.h"

#include <algorithm>
#include <cmath>

#include "render/denoise/plane_memory.h"

namespace pdr {
namespace {

/// An upper bound on radiance: anything brighter is far beyond white. Its square is still finite.
constexpr double kBrightest = 1e15;

/// Factor on the variance of all samples when they are denoised: weights that are computed from the very pixels that
/// they average follow the pixels' noise. With 1 the image of 16 samples is 14 % worse than the mean of its halves,
/// each denoised alone, on rendered tissue; with 1.5 it is as good; with 2 fine lines vanish earlier than in the
/// halves.
constexpr float kTolerance = 1.5f;

constexpr int kLendRadius = 8;  ///< radius of a square with several lit samples where one in a hundred is lit

/// Returns a power of two, which scales without rounding.
double unitFor(double meanLuminance) {
    return meanLuminance > 0 ? std::exp2(std::clamp(std::ilogb(meanLuminance), -120, 120)) : 1;
}

NoisyFilm::Part partOf(ivec2 size) {
    return {denoise::coloursOf(size), denoise::Plane(size)};
}

void setMean(NoisyFilm::Part& part, int x, int y, dvec3 mean) {
    for (int c = 0; c < 3; ++c)
        part.mean[c].row(y)[x] = float(std::min(mean[c], kBrightest));
}

/// Sets the two halves of the samples of a pixel, which has at least 2.
void setHalves(NoisyFilm& film, int x, int y, const PixelEstimate& pixel) {
    const double ofOne = double(film.all.variance.row(y)[x]) * double(pixel.count);
    const double evens = std::ceil(double(pixel.count) / 2), odds = double(pixel.count) - evens;
    setMean(film.even, x, y, pixel.halves.even / film.unit);
    setMean(film.odd, x, y, pixel.halves.odd / film.unit);
    film.even.variance.row(y)[x] = float(ofOne / evens);
    film.odd.variance.row(y)[x] = float(ofOne / odds);
}

void setPixel(NoisyFilm& film, int x, int y, const PixelEstimate& pixel) {
    const double error = std::min(luminance(pixel.standardError) / film.unit, kBrightest);
    setMean(film.all, x, y, pixel.mean / film.unit);
    film.all.variance.row(y)[x] = float(error * error);
    if (pixel.count >= 2)
        setHalves(film, x, y, pixel);
}

void mirror(NoisyFilm::Part& part) {
    for (denoise::Plane& plane : part.mean)
        plane.mirror();
    part.variance.mirror();
}

/// Flags of pixels that show tissue (1), and of those among them that have seen no light though they may.
struct Tissue {
    denoise::Plane met, unlit;
};

/// Gives each pixel that has seen no light the noise of the tissue around it: its own samples do not show any, but its
/// noise is not 0.
void lendNoise(const Tissue& tissue, NoisyFilm& film) {
    const auto times = [](float a, float b) { return a * b; };
    const denoise::Plane sums = denoise::boxed(denoise::combined(times, film.all.variance, tissue.met), kLendRadius);
    const denoise::Plane counts = denoise::boxed(tissue.met, kLendRadius);
    const auto lend = [&](NoisyFilm::Part& part, float share) {
        part.variance = denoise::combined(
            [share](float own, float unlit, float sum, float count) { return unlit > 0 ? share * sum / count : own; },
            part.variance, tissue.unlit, sums, counts);
    };
    lend(film.all, 1.0f);
    lend(film.even, 2.0f);
    lend(film.odd, 2.0f);
}

denoise::Plane ratioOf(const NoisyFilm& film) {
    const auto difference = [](float a, float b) { return a - b; };
    const auto sum = [](float a, float b) { return a + b; };
    return denoise::noiseRatio(
        denoise::combined(difference, denoise::luminance(film.even.mean), denoise::luminance(film.odd.mean)),
        denoise::combined(sum, film.even.variance, film.odd.variance));
}

}  // namespace

NoisyFilm noisyFilm(const Film& film, const std::stop_token& stop) {
    const ivec2 size = film.size();
    // Read the means, the halves and the variances of the pixels
    NoisyFilm noisy{unitFor(film.status().meanLuminance), partOf(size), partOf(size), partOf(size), {}};
    Tissue tissue{denoise::Plane(size), denoise::Plane(size)};
    denoise::eachBand(size.y, stop, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < size.x; ++x) {
                const PixelEstimate pixel = film.pixel(x, y);
                setPixel(noisy, x, y, pixel);
                tissue.met.row(y)[x] = float(pixel.tissue);
                tissue.unlit.row(y)[x] = float(pixel.tissue && pixel.unlit);
            }
    });
    if (stop.stop_requested())
        return noisy;
    tissue.met.mirror();
    for (NoisyFilm::Part* part : {&noisy.all, &noisy.even, &noisy.odd})
        mirror(*part);
    // Estimate the ratio of real to presumed noise from the halves
    if (film.samplesPerPixel() >= 2) {
        noisy.ratio = ratioOf(noisy);
        lendNoise(tissue, noisy);
        return noisy;
    }
    // Without halves, estimate the variance from the neighbours
    noisy.all.variance = denoise::varianceAround(denoise::luminance(noisy.all.mean));
    noisy.ratio = denoise::combined([](float) { return 1.0f; }, noisy.all.variance);
    noisy.even = noisy.odd = noisy.all;
    return noisy;
}

denoise::Colours smoothRadiance(const NoisyFilm& noisy, const std::stop_token& stop,
                                const denoise::Features* features) {
    const auto tolerated = [](float variance) { return kTolerance * variance; };
    return denoise::denoised(noisy.all.mean, denoise::combined(tolerated, noisy.all.variance), noisy.ratio, stop,
                             features);
}

void dropNoisyFilms() {
    denoise::dropKeptForPlanes();
}

}  // namespace pdr
