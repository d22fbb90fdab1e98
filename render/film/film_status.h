#pragma once
/// The quality of a whole image so far, in a few numbers.
///   tissue    the pixels in which a sample met some; errors refer to the tissue alone, so that empty background around
///             the anatomy changes nothing. In an image without tissue they refer to all pixels.
///   unknown   infinite: too few samples, or all that were taken are alike although chance has a part in them

#include <cstdint>
#include <limits>

#include "render/base/health.h"

namespace pdr {

/// Samples per pixel below which nothing is stated about display levels.
inline constexpr std::uint64_t kSamplesToEstimate = 32;
/// Samples per pixel below which nothing is stated about an image of a model without scattering, in which chance
/// decides only where a sample lies in its pixel: one sample of each half.
inline constexpr std::uint64_t kSamplesWithoutChance = 2;
constexpr std::uint64_t samplesToEstimate(bool chance) {
    return chance ? kSamplesToEstimate : kSamplesWithoutChance;
}

struct FilmStatus {
    std::uint64_t samplesPerPixel = 0;      ///< samples that every pixel has
    double meanSamplesPerPixel = 0;         ///< mean over the pixels
    std::uint64_t mostSamplesPerPixel = 0;  ///< most samples that a pixel has
    Health health;
    double meanLuminance = 0;  ///< mean over all pixels
    /// Root mean square over the tissue of the error's luminance, divided by the tissue's mean luminance. It comes from
    /// the differences between the two halves of the samples, or, of fewer than 100 pixels, from standard errors, which
    /// state more than that. Unknown below 2 samples and while nothing that chance decides was seen; 0 for an image
    /// without noise.
    double relativeError = 0;
    /// Margin in display levels, [0, 255]: 95 % of the tissue is shown within so many levels of what it would be
    /// without noise; see display_error.h. Unknown below samplesToEstimate() samples, without tissue, and without a
    /// display.
    double displayError = std::numeric_limits<double>::infinity();
    /// Standard deviation of displayError itself [levels], whatever the errors' distribution: the number of N pixels
    /// below a percentile is binomially distributed. 0 where displayError is not known.
    double displayErrorSpread = 0;
    std::uint64_t tissuePixels = 0;
    /// Lower bound of the share of the tissue that no sample has met yet; no error stated for the tissue includes it.
    double unseenTissue = 0;
    /// Whether more than a quarter of the noise comes from pixels that less than two bright samples made. Brighter ones
    /// may still come then: what is predicted from their error is a lower bound.
    bool fewBrightSamples = false;
    /// Whether more than a twentieth of the tissue has seen no light although it may. Until light is found displayError
    /// is then the margin stated for that tissue, a bound that falls with the number of samples alone.
    bool unlitTissue = false;
    /// Root mean square over the tissue of the standard errors of independent samples, divided by that of the errors
    /// estimated from the halves: what low-discrepancy points have gained so far, about 1 to 5. 0: not known.
    double gain = 0;
    /// Upper bound, to 95 %, of the fraction of samples that may bring other light than was seen, while relativeError
    /// is unknown because all samples were alike. 0 otherwise.
    double unseenShare = 0;
};

}  // namespace pdr
