#include "render/film/error/level_error_map.h"

#include <algorithm>

#include "render/film/error/channel_margin.h"
#include "render/film/error/likely_error.h"

namespace pdr {
namespace {

constexpr double kSigmas = 1.96;  ///< 95 % of a normal distribution lie within so many to either side
constexpr float kUnknown = std::numeric_limits<float>::infinity();

/// Returns the standard error of `pixel`, from `errors` at (x, y).
dvec3 errorOf(const PixelEstimate& pixel, const denoise::Colours& errors, int x, int y) {
    if (pixel.count < kSamplesToEstimate)
        return dvec3(double(kUnknown));
    return {errors[0].row(y)[x], errors[1].row(y)[x], errors[2].row(y)[x]};
}

}  // namespace

std::uint8_t levelBinOf(float levels) {
    if (std::isinf(levels))
        return kUnknownBin;
    if (!(levels > float(kFinestLevels)))
        return kFirstBin;
    const long bin = kFirstBin + std::lround(kBinsPerDoubling * std::log2(double(levels) / kFinestLevels));
    return std::uint8_t(std::min<long>(bin, kLastBin));
}

float levelsWithin(dvec3 mean, dvec3 error, const Tone& tone, float correlation) {
    if (std::isinf(error.x) || std::isinf(error.y) || std::isinf(error.z))
        return kUnknown;
    const DisplayTransform transform = displayTransform(tone);
    const vec3 shown(mean / transform.exposure), off(kSigmas * error / transform.exposure);
    return std::max(levelsApart(transform, shown, off, correlation), levelsApart(transform, shown, -off, correlation));
}

LevelErrorsAt levelErrorsAt(const Film& film, ivec2 pixel, int side, const Tone& tone) {
    const ivec2 corner = glm::max(pixel - (side - 1) / 2, ivec2(0));
    const ivec2 end = glm::min(pixel - (side - 1) / 2 + side, film.size());
    const Tile square{corner.x, corner.y, end.x - corner.x, end.y - corner.y};
    const auto [errors, correlation] = likelyErrorsAndCorrelation(film, square);
    LevelErrorsAt found{.side = side};
    dvec3 light(0.0), squares(0.0);
    float together = 0;
    for (int y = 0; y < square.height; ++y)
        for (int x = 0; x < square.width; ++x) {
            const PixelEstimate one = film.pixel(corner.x + x, corner.y + y);
            const dvec3 error = errorOf(one, errors, x, y);
            light += one.mean;
            squares += error * error;
            together += correlation.row(y)[x];
            if (corner + ivec2(x, y) == pixel) {
                found.tissue = one.tissue;
                found.here = levelsWithin(one.mean, error, tone, correlation.row(y)[x]);
            }
        }
    const double pixels = double(pixelCount(square));
    found.over = levelsWithin(light / pixels, glm::sqrt(squares) / pixels, tone, together / float(pixels));
    return found;
}

/// Works band by band, so that the planes of a band stay in the cache.
LevelErrorMap levelErrorMap(const Film& film, const Tone& tone, const std::stop_token& stop) {
    const ivec2 size = film.size();
    LevelErrorMap map{size, std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y), kNoTissueBin)};
    const bool estimates = film.samples().most >= kSamplesToEstimate;
    denoise::eachBand(size.y, stop, [&](int begin, int end) {
        const LikelyErrors likely =
            estimates ? likelyErrorsAndCorrelation(film, {0, begin, size.x, end - begin}) : LikelyErrors();
        std::uint8_t* bin = &map.bins[std::size_t(begin) * std::size_t(size.x)];
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < size.x; ++x, ++bin) {
                const PixelEstimate pixel = film.pixel(x, y);
                if (!pixel.tissue)
                    continue;
                const dvec3 error = errorOf(pixel, likely.errors, x, y - begin);
                const float correlation = estimates ? likely.correlation.row(y - begin)[x] : 1;
                *bin = levelBinOf(levelsWithin(pixel.mean, error, tone, correlation));
            }
    });
    return map;
}

}  // namespace pdr
