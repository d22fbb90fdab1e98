#pragma once
/// The sums from which the status of an image is computed. The same arithmetic on every device.

#include "render/film/display_error.h"
#include "render/film/film_status.h"
#include "render/film/tile_progress.h"

namespace pdr {

/// Returns whether a pixel has seen no light although it may: its samples may only have been unlucky. `seen`: kSeen...
PDR_HD inline bool isUnlit(const Moments& pixel, std::uint32_t seen) {
    return (seen & kSeenChance) != 0 && pixel.mean == dvec3(0);
}

/// Returns whether a pixel shows tissue and its own samples show its error.
PDR_HD inline bool knowsItsError(const Moments& pixel, std::uint32_t seen) {
    return (seen & kSeenTissue) != 0 && !isUnlit(pixel, seen);
}

/// Returns whether less than two bright samples could make a pixel: k of them among many dark ones give its mean
/// `light` a standard error of light / sqrt(k).
PDR_HD inline bool isRareLight(double light, double standardError) {
    return 2 * standardError * standardError > light * light;
}

/// The share of the noise that may come from pixels of rare light: above it, brighter samples may still come. It is not
/// a share of the pixels: dim ones along a silhouette are many, and their noise is negligible.
inline constexpr double kMostRareNoise = 0.25;

/// Returns the number of groups of a pixel's samples that met tissue, 3 for more. `seen`: kSeen...
PDR_HD inline int groupsThatMet(std::uint32_t seen) {
    std::uint32_t groups = seen >> kFirstGroupBit;
    int count = 0;
    for (; groups != 0 && count < 3; groups &= groups - 1)
        ++count;
    return count;
}

/// Sums over some of an image's pixels.
struct StatusSums {
    double luminance = 0, tissueLuminance = 0;   ///< over all pixels; over those that have seen tissue
    double squaredDraws = 0, tissueDraws = 0;    ///< squared luminance of the errors' draws; the same two
    double squaredErrors = 0, tissueErrors = 0;  ///< squared luminance of the standard errors; the same two
    double rareErrors = 0;                       ///< part of tissueErrors from pixels of rare light
    double tissuePower = 0;                      ///< sum of the mean squared luminance of the tissue's samples
    std::uint64_t tissue = 0;                    ///< pixels that have seen tissue
    std::uint64_t unlit = 0;                     ///< tissue pixels without light that may only be unlucky
    std::uint64_t chance = 0;                    ///< pixels in which chance has a part
    std::uint64_t metOnce = 0, metTwice = 0;     ///< pixels in which one group of the samples met tissue, and two did

    /// Adds one pixel. `seen`: kSeen...
    PDR_HD void add(const Moments& pixel, dvec3 errorDraw, std::uint32_t seen) {
        const double draw = pdr::luminance(errorDraw), light = pdr::luminance(pixel.mean);
        const double error = pdr::luminance(standardErrorOf(pixel));
        luminance += light;
        squaredDraws += draw * draw;
        squaredErrors += error * error;
        chance += (seen & kSeenChance) != 0;
        if ((seen & kSeenTissue) == 0)
            return;
        ++tissue;
        const int groups = groupsThatMet(seen);
        metOnce += groups == 1;
        metTwice += groups == 2;
        tissueLuminance += light;
        tissueDraws += draw * draw;
        tissueErrors += error * error;
        rareErrors += isRareLight(light, error) ? error * error : 0;
        tissuePower += light * light + double(pixel.count) * error * error;
        unlit += isUnlit(pixel, seen);
    }
    PDR_HD void add(const StatusSums& other) {
        luminance += other.luminance;
        tissueLuminance += other.tissueLuminance;
        squaredDraws += other.squaredDraws;
        tissueDraws += other.tissueDraws;
        squaredErrors += other.squaredErrors;
        tissueErrors += other.tissueErrors;
        rareErrors += other.rareErrors;
        tissuePower += other.tissuePower;
        tissue += other.tissue;
        unlit += other.unlit;
        chance += other.chance;
        metOnce += other.metOnce;
        metTwice += other.metTwice;
    }
};

/// The display that an image is shown on, and the errors of its pixels there.
struct Shown {
    const ErrorCounts& errors;  ///< errors of the pixels for which knowsItsError()
    double exposure;
};

/// Returns the status of an image of that many `pixels` from the sums over them.
FilmStatus statusOf(const StatusSums& sums, std::size_t pixels, const SampleCounts& samples, const Health& health);
/// Returns the status together with its displayError.
FilmStatus statusOf(const StatusSums& sums, std::size_t pixels, const SampleCounts& samples, const Health& health,
                    const Shown& shown);

}  // namespace pdr
