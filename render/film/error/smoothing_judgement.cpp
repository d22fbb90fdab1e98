#include "render/film/error/smoothing_judgement.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render/base/significance.h"
#include "render/film/tone_curve.h"

namespace pdr {
namespace {

constexpr int kTile = 16;  ///< edge [pixels] of tiles whose errors count as one draw: wider than most blotches
constexpr int kFewestTiles = 16, kMapRadius = 10;
/// Share of the pixels that may be dark: as many are left out of a statement about 95 %.
constexpr double kMostDark = 0.05;
constexpr double kSureEnough = 3;  ///< -ln(1 - 0.95): what did not occur in n draws has a probability of at most 3 / n

/// Returns the number of standard deviations of a one-sided 95 %. The noise of few samples is skewed and its spread is
/// poorly known, so Student's t is used with one degree of freedom less for each half.
double sureEnough(std::uint64_t samples) {
    return studentT(0.1, int(std::min<std::uint64_t>(samples - 2, 1000)));
}

/// Factors on the root mean square that 95 % of the pixels stay below: for normal errors, and for errors with the
/// widest tails that were seen (many bounces, 64 samples).
constexpr double kLevels = 2, kMostLevels = 2.1;

/// The factor of hiddenContrast, in standard deviations of the noise: measured with lines drawn into images of bone
/// and of smooth shading, 4 to 256 samples per pixel.
constexpr double kHiddenSigmas = 1.8;

float square(float value) {
    return value * value;
}

/// The luminance or one channel of a pixel, from each half of its samples, denoised and raw.
struct Halves {
    float smoothEven, smoothOdd, even, odd;

    float smooth() const { return (smoothEven + smoothOdd) / 2; }
    float raw() const { return (even + odd) / 2; }
    /// Returns an unbiased estimate of the squared error of smooth(): the noise of the raw halves is subtracted, and so
    /// is the amount by which the mean of the denoised halves is better than either.
    float squaredError() const {
        const float judged = square(smoothEven - odd) + square(smoothOdd - even);
        return (judged - square(even - odd)) / 2 - square(smoothEven - smoothOdd) / 4;
    }
};

Halves luminanceOf(const std::array<Halves, 3>& channels) {
    const auto sum = [&](float Halves::*part) {
        return 0.2126f * channels[0].*part + 0.7152f * channels[1].*part + 0.0722f * channels[2].*part;
    };
    return {sum(&Halves::smoothEven), sum(&Halves::smoothOdd), sum(&Halves::even), sum(&Halves::odd)};
}

denoise::Plane meanLuminance(const denoise::Colours& a, const denoise::Colours& b) {
    return denoise::combined([](float one, float other) { return (one + other) / 2; }, denoise::luminance(a),
                             denoise::luminance(b));
}

/// Returns the slope of the tone curve [levels per radiance in units of the exposure] for an error of about `error`:
/// the secant to `radiance` from twice the error below. The curve bends most in the dark, where its tangent would be
/// too flat.
float levelSlope(float radiance, float error) {
    const float* curve = displayCurve();
    const float step = std::max(2 * error, radiance / 16 + 0x1p-14f);
    const float low = std::max(radiance - step, 0.0f), high = std::max(radiance, low + 0x1p-14f);
    return (exactLevelOf(curve, high) - exactLevelOf(curve, low)) / (high - low);
}

Tile intersection(const Tile& a, const Tile& b) {
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    const int right = std::min(a.x + a.width, b.x + b.width), below = std::min(a.y + a.height, b.y + b.height);
    return {x, y, std::max(right - x, 0), std::max(below - y, 0)};
}

}  // namespace

/// Sums over tiles.
struct SmoothingJudgement::Sums {
    double tiles = 0, pixels = 0, luminance = 0, variance = 0;
    double noise = 0, rareNoise = 0;
    double power = 0;  ///< sum of the samples' mean squared luminance
    /// Pixels without light; those of tiles that have no others; the number of such tiles.
    double unlit = 0, dark = 0, darkTiles = 0;
    dvec4 errors{0.0};   ///< squared errors: of the luminance, and of each channel in levels
    dvec4 squares{0.0};  ///< squares of the tiles' sums of errors

    void add(const Sums& tile) {
        tiles += tile.pixels > 0;
        pixels += tile.pixels;
        luminance += tile.luminance;
        variance += tile.variance;
        noise += tile.noise;
        rareNoise += tile.rareNoise;
        power += tile.power;
        unlit += tile.unlit;
        const bool isDark = tile.pixels > 0 && tile.unlit == tile.pixels;
        dark += isDark ? tile.pixels : 0;
        darkTiles += isDark;
        errors += tile.errors;
        squares += tile.errors * tile.errors;
    }
    /// Returns the radiance that a dark tile may have: a few of its samples may be as bright as those elsewhere without
    /// having been drawn. 0 where the dark pixels are no more than what a 95 % statement leaves out.
    double inTheDark(double samplesPerPixel) const {
        return dark > kMostDark * pixels ? kSureEnough * darkTiles / (dark * samplesPerPixel) * (power / luminance) : 0;
    }
    /// Returns the root mean squares of `errors`, raised by `sigmas` standard deviations of the tiles. Sums that chance
    /// has made negative count as 0.
    dvec4 rootMeans(double sigmas) const {
        const dvec4 spread = glm::sqrt(glm::max(squares - errors * errors / tiles, dvec4(0.0)));
        return glm::sqrt(glm::max(errors + sigmas * spread, dvec4(0.0)) / pixels);
    }
};

SmoothHalves denoisedHalves(const NoisyFilm& noisy, const std::stop_token& stop) {
    return {denoise::denoised(noisy.even.mean, noisy.even.variance, noisy.ratio, stop),
            denoise::denoised(noisy.odd.mean, noisy.odd.variance, noisy.ratio, stop)};
}

std::optional<SmoothingJudgement> SmoothingJudgement::of(const Film& film, const HalfSmoother& smoother,
                                                         const std::stop_token& stop) {
    if (film.samplesPerPixel() < kSamplesToJudge)
        return std::nullopt;
    NoisyFilm noisy = noisyFilm(film, stop);
    noisy.all.mean = {};  // only the halves are judged
    if (stop.stop_requested())
        return std::nullopt;
    const SmoothHalves smooth = smoother(noisy, stop);
    if (stop.stop_requested())
        return std::nullopt;
    SmoothingJudgement judgement(film, noisy, smooth.even, smooth.odd, stop);
    if (stop.stop_requested())
        return std::nullopt;
    return judgement;
}

SmoothingJudgement::SmoothingJudgement(const Film& film, const NoisyFilm& noisy, const denoise::Colours& even,
                                       const denoise::Colours& odd, const std::stop_token& stop)
    : area_(film.area()),
      unit_(noisy.unit),
      samples_(double(film.samplesPerPixel())),
      sigmas_(sureEnough(film.samplesPerPixel())) {
    const denoise::Plane variance = denoise::realVariance(noisy.all.variance, noisy.ratio);
    evidence_.resize(std::size_t(area_.width) * std::size_t(area_.height));
    denoise::eachBand(area_.height, stop, [&](int begin, int end) {
        Evidence* next = &evidence_[std::size_t(begin) * std::size_t(area_.width)];
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < area_.width; ++x) {
                Evidence& pixel = *next++;
                std::array<Halves, 3> channels;
                for (int c = 0; c < 3; ++c) {
                    channels[c] = {even[c].row(y)[x], odd[c].row(y)[x], noisy.even.mean[c].row(y)[x],
                                   noisy.odd.mean[c].row(y)[x]};
                    pixel.smooth[c] = channels[c].smooth();
                    pixel.squaredErrors[c] = channels[c].squaredError();
                }
                const Halves luminance = luminanceOf(channels);
                pixel.luminance = luminance.raw();
                pixel.squaredError = luminance.squaredError();
                pixel.variance = variance.row(y)[x];
                const PixelEstimate raw = film.pixel(x, y);
                const double error = pdr::luminance(raw.standardError);
                pixel.noise = square(float(error / unit_));
                pixel.rare = isRareLight(pdr::luminance(raw.mean), error);
                pixel.tissue = raw.tissue;
                pixel.unlit = raw.unlit;
            }
    });
    tissue_ = std::ranges::any_of(evidence_, &Evidence::tissue);
    lostLines_ =
        denoise::lostLines(meanLuminance(noisy.even.mean, noisy.odd.mean), meanLuminance(even, odd), variance, stop);
}

/// Returns the sums over one tile. `exposure`: in units of unit_; `error`: about how far pixels are off, in units of
/// the exposure.
SmoothingJudgement::Sums SmoothingJudgement::sumsIn(const Tile& tile, float exposure, float error) const {
    Sums sums;
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            const std::size_t row = std::size_t(y - area_.y) * std::size_t(area_.width);
            const Evidence& pixel = evidence_[row + std::size_t(x - area_.x)];
            if (tissue_ && !pixel.tissue)
                continue;
            ++sums.pixels;
            sums.luminance += double(pixel.luminance);
            sums.variance += double(pixel.variance);
            sums.noise += double(pixel.noise);
            sums.rareNoise += pixel.rare ? double(pixel.noise) : 0;
            sums.power += double(square(pixel.luminance) + float(samples_) * pixel.noise);
            sums.unlit += pixel.unlit;
            sums.errors[0] += double(pixel.squaredError);
            for (int c = 0; c < 3; ++c) {
                const float slope = levelSlope(pixel.smooth[c] / exposure, error) / exposure;
                sums.errors[c + 1] += double(slope * slope * pixel.squaredErrors[c]);
            }
        }
    return sums;
}

SmoothingJudgement::Sums SmoothingJudgement::sumsOver(const Tile& region, float exposure, float error) const {
    const int across = (region.width + kTile - 1) / kTile, down = (region.height + kTile - 1) / kTile;
    std::vector<Sums> tiles(std::size_t(across) * std::size_t(down));
    tbb::parallel_for(0, int(tiles.size()), [&](int i) {
        const Tile tile{region.x + i % across * kTile, region.y + i / across * kTile, kTile, kTile};
        tiles[std::size_t(i)] = sumsIn(intersection(tile, region), exposure, error);
    });
    Sums sums;
    for (const Sums& tile : tiles)  // in a fixed order: the same bits for any number of threads
        sums.add(tile);
    return sums;
}

LevelErrorMap SmoothingJudgement::errorMap(double exposure, double stated) const {
    const auto inUnits = float(exposure / unit_);
    // Collect the squared error of each tissue pixel's worst channel, in levels
    denoise::Plane squares(ivec2(area_.width, area_.height)), counts = squares;
    for (int y = 0; y < area_.height; ++y)
        for (int x = 0; x < area_.width; ++x) {
            const Evidence& pixel = evidence_[std::size_t(y) * std::size_t(area_.width) + std::size_t(x)];
            if (!pixel.tissue)
                continue;
            counts.row(y)[x] = 1;
            const float error = std::sqrt(std::max(pixel.squaredError, 0.0f)) / inUnits;
            for (int c = 0; c < 3; ++c) {
                const float slope = levelSlope(pixel.smooth[c] / inUnits, error) / inUnits;
                squares.row(y)[x] = std::max(squares.row(y)[x], slope * slope * pixel.squaredErrors[c]);
            }
        }
    squares.mirror();
    counts.mirror();
    // Average them over the neighbourhood of each pixel
    const denoise::Plane sums = denoise::boxed(squares, kMapRadius), pixels = denoise::boxed(counts, kMapRadius);
    LevelErrorMap map{ivec2(area_.width, area_.height), {}};
    map.bins.reserve(evidence_.size());
    for (int y = 0; y < area_.height; ++y)
        for (int x = 0; x < area_.width; ++x) {
            const float square = std::max(sums.row(y)[x] / pixels.row(y)[x], 0.0f);
            const float levels = std::max(float(kLevels) * std::sqrt(square), float(stated / 8));
            map.bins.push_back(counts.row(y)[x] > 0 ? levelBinOf(levels) : kNoTissueBin);
        }
    return map;
}

std::optional<DenoisedError> SmoothingJudgement::over(const Tile& region, double exposure) const {
    const Tile inside = intersection(region, area_);
    const auto inUnits = float(exposure / unit_);
    const Sums linear = sumsOver(inside, inUnits, 0);
    if (linear.tiles < kFewestTiles || linear.rareNoise > kMostRareNoise * linear.noise ||
        (linear.unlit > 0 && !(linear.luminance > 0)))
        return std::nullopt;
    const double error = linear.rootMeans(0)[0], atMost = linear.rootMeans(sigmas_)[0];
    const Sums shown = sumsOver(inside, inUnits, float(atMost) / inUnits);
    const double mean = linear.luminance / linear.pixels;
    const auto relative = [mean](double off) { return off > 0 ? off / mean : 0; };
    const auto worstChannel = [](const dvec4& all) { return std::max({all[1], all[2], all[3]}); };
    const double dark = double(exactLevelOf(displayCurve(), float(linear.inTheDark(samples_) / double(inUnits))));
    return DenoisedError{relative(error), relative(atMost), kLevels * worstChannel(shown.rootMeans(0)),
                         std::max(kMostLevels * worstChannel(shown.rootMeans(sigmas_)), dark),
                         kHiddenSigmas * relative(std::sqrt(linear.variance / linear.pixels))};
}

}  // namespace pdr
