#include "render/film/error/smoothing_judgement.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/base/significance.h"
#include "render/film/error/judged_levels.h"
#include "render/film/tone_curve.h"

namespace pdr {
namespace {

constexpr int kTile = 16;  ///< edge [pixels] of tiles whose errors count as one draw: wider than most blotches
constexpr int kFewestTiles = 2 * ErrorClasses::kBrightness, kMapRadius = 10;
constexpr float kMostApart = 10;  ///< most that errors around a pixel differ from those of its class [variance]
/// Share of the pixels that may be dark: as many are left out of a statement about 95 %.
constexpr double kMostDark = 0.05;
constexpr double kSureEnough = 3;  ///< -ln(1 - 0.95): what did not occur in n draws has a probability of at most 3 / n

/// Returns the number of standard deviations of a one-sided 95 %. The noise of few samples is skewed and its spread is
/// poorly known, so Student's t is used with one degree of freedom less for each half.
double sureEnough(std::uint64_t samples) {
    return studentT(0.1, int(std::min<std::uint64_t>(samples - 2, 1000)));
}

/// Factor on the margins of pixels and on the upper bound: errors have wider tails than normal ones, and in the darkest
/// and the brightest class, which chance has a part in filling, the halves differ by less than elsewhere.
constexpr float kWideTails = 1.1f;

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

Halves weighted(const std::array<Halves, 3>& channels, vec3 weights) {
    const auto sum = [&](float Halves::*part) {
        return weights.x * channels[0].*part + weights.y * channels[1].*part + weights.z * channels[2].*part;
    };
    return {sum(&Halves::smoothEven), sum(&Halves::smoothOdd), sum(&Halves::even), sum(&Halves::odd)};
}

Halves luminanceOf(const std::array<Halves, 3>& channels) {
    return weighted(channels, {0.2126f, 0.7152f, 0.0722f});
}

denoise::Plane meanLuminance(const denoise::Colours& a, const denoise::Colours& b) {
    return denoise::combined([](float one, float other) { return (one + other) / 2; }, denoise::luminance(a),
                             denoise::luminance(b));
}

/// Returns the bin of a pixel among its eight neighbours.
LookBin lookAt(const denoise::Plane& luminance, int x, int y) {
    float low = luminance.row(y)[x], high = low;
    for (int row = y - 1; row <= y + 1; ++row)
        for (int column = x - 1; column <= x + 1; ++column) {
            low = std::min(low, luminance.row(row)[column]);
            high = std::max(high, luminance.row(row)[column]);
        }
    return LookBin::of(luminance.row(y)[x], low, high);
}

SmoothHalves halvesOn(const denoise::Features* features, const NoisyFilm& noisy, const std::stop_token& stop) {
    const auto denoised = [&](const NoisyFilm::Part& half) {
        return denoise::denoised(half.mean, half.variance, noisy.ratio, stop, features);
    };
    return {denoised(noisy.even), denoised(noisy.odd)};
}

/// Returns the sum of what addTile(sums, tile) adds for each tile of kTile x kTile pixels of a region, in an order that
/// does not depend on the number of threads. `none`: a sum of nothing.
template <class Sums, class AddTile>
Sums overTiles(const Tile& region, const Sums& none, const AddTile& addTile) {
    std::vector<Sums> rows(std::size_t((region.height + kTile - 1) / kTile), none);
    tbb::parallel_for(0, int(rows.size()), [&](int row) {
        for (int x = region.x; x < region.x + region.width; x += kTile)
            addTile(rows[std::size_t(row)], intersection({x, region.y + row * kTile, kTile, kTile}, region));
    });
    Sums sums = none;
    for (const Sums& row : rows)
        sums.add(row);
    return sums;
}

}  // namespace

/// Sums over tiles.
struct SmoothingJudgement::Sums {
    double tiles = 0, pixels = 0, luminance = 0, variance = 0;
    double noise = 0, rareNoise = 0;
    double power = 0;  ///< sum of the samples' mean squared luminance
    /// Pixels without light; those of tiles that have no others; the number of such tiles.
    double unlit = 0, dark = 0, darkTiles = 0;
    double errors = 0;   ///< squared errors of the luminance
    double squares = 0;  ///< squares of the tiles' sums of errors

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
    /// Returns the root mean square of `errors`, raised by `sigmas` standard deviations of the tiles. A sum that chance
    /// has made negative counts as 0.
    double rootMean(double sigmas) const {
        const double spread = std::sqrt(std::max(squares - errors * errors / tiles, 0.0));
        return std::sqrt(std::max(errors + sigmas * spread, 0.0) / pixels);
    }
};

SmoothHalves denoisedHalves(const NoisyFilm& noisy, const std::stop_token& stop) {
    return halvesOn(nullptr, noisy, stop);
}

HalfSmoother smootherOn(std::shared_ptr<const denoise::Features> features) {
    return [features = std::move(features)](const NoisyFilm& noisy, const std::stop_token& stop) {
        return halvesOn(features.get(), noisy, stop);
    };
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
    const denoise::Plane smooth = meanLuminance(even, odd);
    evidence_.resize(pixelCount(area_));
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
                pixel.squaredSum = weighted(channels, vec3(1)).squaredError();
                const Halves luminance = luminanceOf(channels);
                pixel.luminance = luminance.raw();
                pixel.squaredError = luminance.squaredError();
                pixel.variance = variance.row(y)[x];
                pixel.look = lookAt(smooth, x, y);
                const PixelEstimate raw = film.pixel(x, y);
                const double error = pdr::luminance(raw.standardError);
                pixel.noise = square(float(error / unit_));
                pixel.rare = isRareLight(pdr::luminance(raw.mean), error);
                pixel.tissue = raw.tissue;
                pixel.unlit = raw.unlit;
            }
    });
    tissue_ = std::ranges::any_of(evidence_, &Evidence::tissue);
    lostLines_ = denoise::lostLines(meanLuminance(noisy.even.mean, noisy.odd.mean), smooth, variance, stop);
}

/// Calls work(pixel, evidence) for each pixel of a tile that counts.
template <class Work>
void SmoothingJudgement::eachJudged(const Tile& tile, const Work& work) const {
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            const std::size_t row = std::size_t(y - area_.y) * std::size_t(area_.width);
            const Evidence& pixel = evidence_[row + std::size_t(x - area_.x)];
            if (!tissue_ || pixel.tissue)
                work(ivec2(x, y), pixel);
        }
}

SmoothingJudgement::Sums SmoothingJudgement::sumsIn(const Tile& tile) const {
    Sums sums;
    eachJudged(tile, [&](ivec2, const Evidence& pixel) {
        ++sums.pixels;
        sums.luminance += double(pixel.luminance);
        sums.variance += double(pixel.variance);
        sums.noise += double(pixel.noise);
        sums.rareNoise += pixel.rare ? double(pixel.noise) : 0;
        sums.power += double(square(pixel.luminance) + float(samples_) * pixel.noise);
        sums.unlit += pixel.unlit;
        sums.errors += double(pixel.squaredError);
    });
    return sums;
}

SmoothingJudgement::Sums SmoothingJudgement::sumsOver(const Tile& region) const {
    const int across = (region.width + kTile - 1) / kTile, down = (region.height + kTile - 1) / kTile;
    std::vector<Sums> tiles(std::size_t(across) * std::size_t(down));
    tbb::parallel_for(0, int(tiles.size()), [&](int i) {
        const Tile tile{region.x + i % across * kTile, region.y + i / across * kTile, kTile, kTile};
        tiles[std::size_t(i)] = sumsIn(intersection(tile, region));
    });
    Sums sums;
    for (const Sums& tile : tiles)  // in a fixed order: the same bits for any number of threads
        sums.add(tile);
    return sums;
}

ErrorClasses SmoothingJudgement::errorsOver(const Tile& region) const {
    return ErrorClasses(overTiles(region, ErrorSums(), [&](ErrorSums& sums, const Tile& tile) {
        eachJudged(tile,
                   [&](ivec2, const Evidence& pixel) { sums.add(pixel.look, pixel.squaredErrors, pixel.squaredSum); });
    }));
}

LevelErrorMap SmoothingJudgement::errorMap(const Tone& tone, double stated) const {
    const ErrorClasses classes = errorsOver(area_);
    // Compare the errors around each pixel with what its class says of them
    denoise::Plane found(ivec2(area_.width, area_.height)), expected = found;
    const auto sumOf = [](vec3 channels) { return channels.x + channels.y + channels.z; };
    eachJudged(area_, [&](ivec2 at, const Evidence& pixel) {
        found.row(at.y - area_.y)[at.x - area_.x] = sumOf(pixel.squaredErrors);
        expected.row(at.y - area_.y)[at.x - area_.x] = sumOf(classes.variance(pixel.look));
    });
    found.mirror();
    expected.mirror();
    const denoise::Plane share = denoise::combined(
        [](float is, float said) { return said > 0 ? glm::clamp(is / said, 1 / kMostApart, kMostApart) : 0.0f; },
        denoise::boxed(found, kMapRadius), denoise::boxed(expected, kMapRadius));
    // State the margin of each pixel
    LevelErrorMap map{ivec2(area_.width, area_.height), std::vector<std::uint8_t>(evidence_.size(), kNoTissueBin)};
    eachJudged(area_, [&](ivec2 at, const Evidence& pixel) {
        if (!pixel.tissue)
            return;
        const ivec2 place = at - ivec2(area_.x, area_.y);
        const vec3 error = kWideTails * glm::sqrt(classes.variance(pixel.look) * share.row(place.y)[place.x]);
        const float levels =
            levelsWithin(unit_ * dvec3(pixel.smooth), unit_ * dvec3(error), tone, classes.correlation(pixel.look));
        map.bins[std::size_t(place.y) * std::size_t(area_.width) + std::size_t(place.x)] =
            levelBinOf(std::max(levels, float(stated / 8)));
    });
    return map;
}

std::optional<DenoisedError> SmoothingJudgement::over(const Tile& region, const Tone& tone) const {
    const Tile inside = intersection(region, area_);
    const Sums linear = sumsOver(inside);
    if (linear.tiles < kFewestTiles || linear.rareNoise > kMostRareNoise * linear.noise ||
        (linear.unlit > 0 && !(linear.luminance > 0)))
        return std::nullopt;
    const Tone inUnits(double(tone.exposure) / unit_, tone.curve);
    const ErrorClasses classes = errorsOver(inside);
    const JudgedLevels shown = overTiles(inside, JudgedLevels(inUnits), [&](JudgedLevels& sums, const Tile& tile) {
        eachJudged(tile, [&](ivec2 at, const Evidence& pixel) {
            sums.add(at, pixel.smooth, classes.variance(pixel.look), pixel.squaredErrors,
                     classes.correlation(pixel.look));
        });
        sums.endTile();
    });
    const double mean = linear.luminance / linear.pixels, levels = shown.levels();
    const auto relative = [mean](double off) { return off > 0 ? off / mean : 0; };
    const double dark =
        double(exactLevelOf(displayCurve(), float(linear.inTheDark(samples_) / double(inUnits.exposure))));
    return DenoisedError{
        relative(linear.rootMean(0)), relative(linear.rootMean(sigmas_)), levels,
        std::max(kWideTails * std::sqrt(1 + sigmas_ * shown.uncertainty(ErrorClasses::kBrightness)) * levels, dark),
        kHiddenSigmas * relative(std::sqrt(linear.variance / linear.pixels))};
}

}  // namespace pdr
