#pragma once
/// Where an image is still rough: each pixel's own 95 % margin [display levels of 255], from what its neighbourhood
/// tells of its error (likely_error.h), put through the display (display_error.h). Where all pixels together are within
/// 8 levels, about a fifth of them have wider margins of their own: most of these are nevertheless off by less.

#include <cmath>
#include <cstdint>
#include <limits>
#include <stop_token>
#include <vector>

#include "render/film/film.h"

namespace pdr {

/// Levels as bytes, even on a logarithmic scale of kBinsPerDoubling bins: from kFirstBin, all up to 1 level, to
/// kLastBin, all from 64 levels on.
inline constexpr std::uint8_t kNoTissueBin = 0, kFirstBin = 1, kLastBin = 253, kUnknownBin = 255;
inline constexpr int kBinsPerDoubling = 42;
inline constexpr double kFinestLevels = 1, kCoarsestLevels = 64;

/// `levels` >= 0; infinite: not known.
std::uint8_t levelBinOf(float levels);
/// In [kFinestLevels, kCoarsestLevels], of a bin that holds levels.
inline double levelsOfBin(std::uint8_t bin) {
    return kFinestLevels * std::exp2(double(bin - kFirstBin) / kBinsPerDoubling);
}

struct LevelErrorMap {
    ivec2 size{0};                   ///< pixels
    std::vector<std::uint8_t> bins;  ///< row by row from the top; kNoTissueBin where no sample met any
};

/// To 95 %, what is shown of `mean`, whose standard error is `error` in each channel, is within so many levels of what
/// it would be without noise: the worst channel's, upwards or downwards, clipped to what a display can show. Infinite
/// where an error is. `exposure`: of the display.
float levelsWithin(dvec3 mean, dvec3 error, double exposure);

/// What is known at one place of a picture [levels, to 95 %]; infinite: not known.
struct LevelErrorsAt {
    bool tissue = false;
    float here = std::numeric_limits<float>::infinity();  ///< of the pixel, as in the map
    int side = 0;                                         ///< of a square around it [pixels]
    float over = std::numeric_limits<float>::infinity();  ///< of the mean of its light: pixels err independently
};

/// At pixel (x, y) of the film, and over side x side pixels around it, side >= 1, as far as the film goes.
LevelErrorsAt levelErrorsAt(const Film& film, ivec2 pixel, int side, double exposure);

/// Of the whole film; pixels below kSamplesToEstimate samples are not known. The same bits for any number of threads;
/// worthless after a stop request.
LevelErrorMap levelErrorMap(const Film& film, double exposure, const std::stop_token& stop = {});

}  // namespace pdr
