#pragma once
/// The error map: the 95 % margin of each pixel [display levels of 255], estimated from its neighbourhood
/// (likely_error.h) and mapped through the display (display_error.h). Where all pixels together are within 8 levels,
/// about a fifth of them have wider margins of their own, but most of these are off by less.

#include <cmath>
#include <cstdint>
#include <limits>
#include <stop_token>
#include <vector>

#include "render/film/film.h"

namespace pdr {

/// Levels are stored as bytes, evenly on a logarithmic scale of kBinsPerDoubling bins per doubling: from kFirstBin, all
/// up to 1 level, to kLastBin, all from 64 levels on.
inline constexpr std::uint8_t kNoTissueBin = 0, kFirstBin = 1, kLastBin = 253, kUnknownBin = 255;
inline constexpr int kBinsPerDoubling = 42;
inline constexpr double kFinestLevels = 1, kCoarsestLevels = 64;

/// Returns the bin of `levels` >= 0; infinite: not known.
std::uint8_t levelBinOf(float levels);
/// Returns the levels of a bin from kFirstBin to kLastBin, in [kFinestLevels, kCoarsestLevels].
inline double levelsOfBin(std::uint8_t bin) {
    return kFinestLevels * std::exp2(double(bin - kFirstBin) / kBinsPerDoubling);
}

struct LevelErrorMap {
    ivec2 size{0};                   ///< pixels
    std::vector<std::uint8_t> bins;  ///< row by row from the top; kNoTissueBin where no sample met tissue
};

/// Returns the 95 % margin [levels] of a pixel of that mean, whose standard error is `error` in each channel: the
/// largest of all channels, upwards or downwards, clipped to what a display of that tone can show. Infinite where an
/// error is infinite. `correlation`: of the channels' errors, as LikelyErrors::correlation.
float levelsWithin(dvec3 mean, dvec3 error, const Tone& tone, float correlation = 1);

/// Errors at one place of an image [levels, to 95 %]; infinite: not known.
struct LevelErrorsAt {
    bool tissue = false;
    float here = std::numeric_limits<float>::infinity();  ///< margin of the pixel, as in the map
    int side = 0;                                         ///< edge of a square around the pixel [pixels]
    float over = std::numeric_limits<float>::infinity();  ///< margin of the square's mean light, independent errors
};

/// Returns the errors at `pixel` of the film, and over side x side pixels around it, side >= 1, as far as the film
/// goes.
LevelErrorsAt levelErrorsAt(const Film& film, ivec2 pixel, int side, const Tone& tone);

/// Returns the error map of the whole film; pixels below kSamplesToEstimate samples are not known. The same bits for
/// any number of threads; worthless after a stop request.
LevelErrorMap levelErrorMap(const Film& film, const Tone& tone, const std::stop_token& stop = {});

}  // namespace pdr
