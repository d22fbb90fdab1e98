#pragma once
/// Causes why an image would differ from the exact one however many samples it gets, each with a name and its size as
/// far as that is known. Noise is another number; see film_status.h.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/accuracy/bias_estimate.h"
#include "render/base/health.h"
#include "render/base/text.h"
#include "render/film/error/smoothing_judgement.h"
#include "render/scene/model.h"
#include "render/scene/schedule.h"

namespace pdr {

enum class BiasCause {
    // Causes in the computation:
    march,          ///< Exposure Render's march of 3 voxels
    blur,           ///< blur of each iteration
    fastFilter,     ///< filtering of the volume by texture units
    runningMean,    ///< mean kept in single precision, without the first iteration
    quadrature,     ///< sums along rays, to a tolerance
    overDense,      ///< see prepare/warnings.h
    leftOut,        ///< samples left out because they were no radiance
    overBound,      ///< extinction above its bound was met
    bounceCap,      ///< paths were ended at the bounce limit
    overTolerance,  ///< rays did not keep their error bound
    smoothing,
    // Causes in how the image is shown:
    resolution,  ///< the image has fewer or more pixels than the view
    // Causes in the scanned data, and by choice:
    interpolatedSlices  ///< a cubic interpolates slices between those of the scan
};

/// Returns the cause's name in reports: "march", "bounceCap".
const char* biasName(BiasCause cause);
bool isOfComputing(BiasCause cause);

/// One cause, or the first of several causes that were measured together.
struct Bias {
    BiasCause cause;
    Text text;  ///< text for the user: "march of 3 voxels: +9.7 % bright, ..."
    // Size of the bias; none if not known:
    std::optional<MeasuredBias> measured = {};  ///< measured against the exact image
    std::optional<double> levelsAtMost = {};    ///< upper bound [display levels of 255]
    std::optional<double> shareAtMost = {};  ///< upper bound of the fraction of the tissue's pixels that are off at all
    std::optional<Fault> fault = {};         ///< fault that it comes from
};

/// Biases measured against the exact image; none if there is no such bias or too little is known.
struct MeasuredBiases {
    std::optional<MeasuredBias> shortcuts;    ///< march, blur and fast filter together
    std::optional<MeasuredBias> runningMean;  ///< for about as many iterations as the image has
    std::optional<MeasuredBias> quadrature;
};

/// Facts from which the causes are derived.
struct BiasFacts {
    Model model = Model::singleScattering;
    Estimator estimator = Estimator::unbiased;
    Schedule schedule;
    bool texturesFilter = false;  ///< texture units read the volume
    double toleranceLevels = 0;   ///< tolerance of projections [display levels]
    Text denseWarning;            ///< see prepare/warnings.h; empty if none
    Health health;
    std::uint64_t tissuePixels = 0;  ///< pixels that show tissue; 0: nothing is known of all pixels
    MeasuredBiases measured;
    std::optional<DenoisedError> denoised;  ///< error of the denoised image, if `isDenoised`
    bool isDenoised = false;
    ivec2 image{0}, view{0};  ///< sizes of image and view [pixels]; 0: the image is not stretched
    bool slicesInterpolated = false;
};

/// Returns the names of the shortcuts whose bias is known only by measurement: "march of 3 voxels, each iteration
/// blurred". Empty: none is in use.
Text shortcutNames(const BiasFacts& facts);
bool keepsRunningMean(const BiasFacts& facts);
bool sumsToATolerance(const BiasFacts& facts);
inline bool needsMeasuring(const BiasFacts& facts) {
    return !shortcutNames(facts).empty() || keepsRunningMean(facts) || sumsToATolerance(facts);
}

/// Returns the biases in the order of the causes. If none is a cause in the computation, no bias is known there.
std::vector<Bias> biases(const BiasFacts& facts);
bool noneOfComputing(const std::vector<Bias>& biases);

}  // namespace pdr
