#pragma once
/// How good a whole picture is by now, in a few numbers.
///   tissue    the pixels in which a sample met some; what is said of the error is said of them, so that empty ground
///             around the anatomy changes nothing. Of a picture without any it is said of all pixels.
///   unknown   infinite: too few samples, or all that were taken are alike although chance has a part in them

#include <cstdint>
#include <limits>

#include "render/base/health.h"

namespace pdr {

/// Samples per pixel below which nothing is said about display levels.
inline constexpr std::uint64_t kSamplesToEstimate = 32;
/// Samples per pixel below which nothing is said of an image of a model without scattering, in which chance decides only
/// where a sample lies in its pixel: one sample of each half.
inline constexpr std::uint64_t kSamplesWithoutChance = 2;
constexpr std::uint64_t samplesToEstimate(bool chance) {
    return chance ? kSamplesToEstimate : kSamplesWithoutChance;
}

struct FilmStatus {
    std::uint64_t samplesPerPixel = 0;  ///< that every pixel has; the mean and the most that one has:
    double meanSamplesPerPixel = 0;
    std::uint64_t mostSamplesPerPixel = 0;
    Health health;
    double meanLuminance = 0;  ///< of all pixels
    /// Root mean square over the tissue of the error's luminance, divided by the tissue's mean luminance: from what the
    /// two halves of the samples differ, or, of fewer than 100 pixels, from standard errors, which say more than that.
    /// Unknown below 2 samples and while nothing that chance decides was seen; 0 for an image without noise.
    double relativeError = 0;
    /// 95 % of the tissue is shown within so many display levels of what it would be without noise, [0, 255]; see
    /// display_error.h. Unknown below samplesToEstimate() samples, without tissue, and without a display.
    double displayError = std::numeric_limits<double>::infinity();
    /// Standard deviation of displayError itself [levels], whatever the errors' distribution: of N pixels so many lie
    /// below a percentile as come of N throws of a coin. 0 where displayError is not known.
    double displayErrorSpread = 0;
    std::uint64_t tissuePixels = 0;
    /// At least this part of the tissue no sample has met yet: it is in none of what is said of the tissue.
    double unseenTissue = 0;
    /// More than a quarter of the noise comes from pixels that less than two bright samples made, so brighter ones may
    /// still come: what is foretold from their error is a lower bound.
    bool fewBrightSamples = false;
    /// More than a twentieth of the tissue has seen no light although it may: displayError is what is stated of it, a
    /// bound that falls with the number of samples alone, until light is found.
    bool unlitTissue = false;
    /// Standard errors over the tissue as if its samples were independent, over those that the halves tell, root mean
    /// squares: what low-discrepancy points have gained by now, about 1 to 5. 0: not known.
    double gain = 0;
    /// While relativeError is unknown because all samples were alike: the fraction of samples that may bring other
    /// light than was seen, at most, to 95 %. 0 otherwise.
    double unseenShare = 0;
};

}  // namespace pdr
