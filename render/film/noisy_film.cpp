#include "render/film/noisy_film.h"

#include <algorithm>
#include <cmath>

namespace pdr {
namespace {

/// What is brighter is far beyond white. Its square is still a number.
constexpr double kBrightest = 1e15;

/// Variance of all samples that counts as one: weights that come from the very pixels that they smooth follow their
/// noise. With 1 the picture of 16 samples is 14 % worse than the mean of its halves, each smoothed alone, on rendered
/// tissue; with 1.5 it is as good, with 2 fine lines go earlier than those of the halves.
constexpr float kTolerance = 1.5f;

/// A power of two, which scales without rounding.
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

/// Its samples, of which there are at least 2, as two halves.
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

denoise::Plane ratioOf(const NoisyFilm& film) {
    const auto difference = [](float a, float b) { return a - b; };
    const auto sum = [](float a, float b) { return a + b; };
    return denoise::noiseRatio(
        denoise::combined(difference, denoise::luminance(film.even.mean), denoise::luminance(film.odd.mean)),
        denoise::combined(sum, film.even.variance, film.odd.variance));
}

}  // namespace

NoisyFilm noisyFilm(const Film& film) {
    const ivec2 size = film.size();
    NoisyFilm noisy{unitFor(film.status().meanLuminance), partOf(size), partOf(size), partOf(size), {}};
    denoise::eachBand(size.y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < size.x; ++x)
                setPixel(noisy, x, y, film.pixel(x, y));
    });
    for (NoisyFilm::Part* part : {&noisy.all, &noisy.even, &noisy.odd})
        mirror(*part);
    if (film.samplesPerPixel() >= 2) {
        noisy.ratio = ratioOf(noisy);
        return noisy;
    }
    noisy.all.variance = denoise::varianceAround(denoise::luminance(noisy.all.mean));
    noisy.ratio = denoise::combined([](float) { return 1.0f; }, noisy.all.variance);
    noisy.even = noisy.odd = noisy.all;
    return noisy;
}

denoise::Colours smoothRadiance(const NoisyFilm& noisy, const std::stop_token& stop) {
    const auto tolerated = [](float variance) { return kTolerance * variance; };
    return denoise::smoothed(noisy.all.mean, denoise::combined(tolerated, noisy.all.variance), noisy.ratio, stop);
}

}  // namespace pdr
