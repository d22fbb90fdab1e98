#include "render/film/status_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pdr {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kSureEnough = 3;  ///< -ln(1 - 0.95): what did not occur in n draws has a probability of at most 3 / n
constexpr double kDisplayFraction = 0.95;

/// The number of draws from which on their mean square is the error's to 7 % (chi-square); fewer draws may state far
/// too little.
constexpr double kDrawsToJudge = 100;

/// Returns the relative error over the tissue, or over all pixels where there is none.
double relativeErrorOf(const StatusSums& sums, std::size_t pixels) {
    const bool tissue = sums.tissue > 0;
    const double count = tissue ? double(sums.tissue) : double(pixels);
    const double mean = (tissue ? sums.tissueLuminance : sums.luminance) / count;
    const double draws = tissue ? sums.tissueDraws : sums.squaredDraws;
    const double atMost = tissue ? sums.tissueErrors : sums.squaredErrors;
    const double error = std::sqrt((count >= kDrawsToJudge ? draws : atMost) / count);
    return error > 0 ? error / mean : 0;
}

/// Returns a lower bound of the share of the tissue that no sample has met, from the numbers of pixels in which few
/// groups of samples have met some. Chao 1987, "Estimating the population size for capture-recapture data with unequal
/// catchability".
double unseenTissueOf(const StatusSums& sums, std::uint64_t samples) {
    const double groups = double(std::min<std::uint64_t>(samples, kSeenGroups));
    if (groups < 2 || sums.tissue == 0)
        return 0;
    const double once = double(sums.metOnce), twice = double(sums.metTwice);
    const double unseen = (groups - 1) / groups * once * std::max(once - 1, 0.0) / (2 * (twice + 1));
    return unseen / (double(sums.tissue) + unseen);
}

/// Returns the margin [levels] of a pixel that has seen tissue but no light: a fraction 3 / n of its samples may bring
/// as much light as those elsewhere.
float unlitLevelsOff(const StatusSums& sums, const SampleCounts& samples, const Shown& shown) {
    const double bright = sums.tissuePower / sums.tissueLuminance;
    const double most = kSureEnough / double(samples.least) * bright;
    return exactLevelOf(displayCurve(), float(most / shown.exposure));
}

}  // namespace

FilmStatus statusOf(const StatusSums& sums, std::size_t pixels, const SampleCounts& samples, const Health& health) {
    FilmStatus status{.samplesPerPixel = samples.least,
                      .meanSamplesPerPixel = samples.mean,
                      .mostSamplesPerPixel = samples.most,
                      .health = health,
                      .tissuePixels = sums.tissue};
    status.meanLuminance = sums.luminance / double(pixels);
    status.relativeError = samples.least < 2 ? kUnknown : relativeErrorOf(sums, pixels);
    if (double(sums.tissue) >= kDrawsToJudge && sums.tissueDraws > 0)
        status.gain = std::sqrt(sums.tissueErrors / sums.tissueDraws);
    status.unlitTissue = double(sums.unlit) > (1 - kDisplayFraction) * double(sums.tissue);
    status.unseenTissue = unseenTissueOf(sums, samples.least);
    status.fewBrightSamples = sums.rareErrors > kMostRareNoise * sums.tissueErrors;
    if (status.relativeError == 0 && sums.chance > 0) {
        status.relativeError = kUnknown;
        status.unseenShare = std::min(kSureEnough / (double(samples.least) * double(sums.chance)), 1.0);
    }
    return status;
}

FilmStatus statusOf(const StatusSums& sums, std::size_t pixels, const SampleCounts& samples, const Health& health,
                    const Shown& shown) {
    FilmStatus status = statusOf(sums, pixels, samples, health);
    if (samples.least < samplesToEstimate(sums.chance > 0) || sums.tissue == 0 || !std::isfinite(status.relativeError))
        return status;
    ErrorCounts errors = shown.errors;
    if (sums.unlit > 0)
        errors.pixels[errorBinOf(unlitLevelsOff(sums, samples, shown))] += std::uint32_t(sums.unlit);
    status.displayError = errorQuantile(errors, kDisplayFraction);
    const double chance = std::sqrt(kDisplayFraction * (1 - kDisplayFraction) / double(sums.tissue));
    status.displayErrorSpread = (errorQuantile(errors, std::min(kDisplayFraction + chance, 1.0)) -
                                 errorQuantile(errors, kDisplayFraction - chance)) /
                                2;
    return status;
}

}  // namespace pdr
