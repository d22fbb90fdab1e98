#pragma once
/// Why a picture would not be the exact one however long one waits: causes with names, each with how much it is, as far
/// as that is known. Noise is another number; see film_status.h.

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
    // In the computing:
    march,          ///< Exposure Render's, of 3 voxels
    blur,           ///< of each iteration
    fastFilter,     ///< of the volume, by texture units
    runningMean,    ///< kept in single precision, without the first iteration
    quadrature,     ///< along rays, to a tolerance
    overDense,      ///< see prepare/warnings.h
    leftOut,        ///< samples that were no radiance
    overBound,      ///< tissue above its bound was met
    bounceCap,      ///< paths were ended
    overTolerance,  ///< rays did not keep their bound
    smoothing,
    // In how it is shown:
    resolution,  ///< fewer or more pixels than the view has
    // In what was scanned, and a choice:
    interpolatedSlices  ///< a cubic put slices between those of the scan
};

/// Its word in reports: "march", "bounceCap".
const char* biasName(BiasCause cause);
bool isOfComputing(BiasCause cause);

/// One cause, or, of those that were measured together, the first of them.
struct Bias {
    BiasCause cause;
    Text text;  ///< for the user: "march of 3 voxels: +9.7 % bright, ..."
    // How much; nothing where that is not known:
    std::optional<MeasuredBias> measured = {};  ///< against the exact picture
    std::optional<double> levelsAtMost = {};    ///< display levels of 255
    std::optional<double> shareAtMost = {};     ///< fraction of the tissue's pixels that may be off at all
    std::optional<Fault> fault = {};            ///< that it comes from
};

/// Against the exact picture; nothing where there is none, or too little is known.
struct MeasuredBiases {
    std::optional<MeasuredBias> shortcuts;    ///< march, blur and fast filter together
    std::optional<MeasuredBias> runningMean;  ///< of as many iterations as the picture has, about
    std::optional<MeasuredBias> quadrature;
};

/// What causes are known from.
struct BiasFacts {
    Model model = Model::singleScattering;
    Estimator estimator = Estimator::unbiased;
    Schedule schedule;
    bool texturesFilter = false;  ///< texture units read the volume
    double toleranceLevels = 0;   ///< of projections
    Text denseWarning;            ///< empty: none
    Health health;
    std::uint64_t tissuePixels = 0;  ///< 0: of all pixels nothing is known
    MeasuredBiases measured;
    std::optional<SmoothedError> smoothed;  ///< of a picture that is smoothed, if `isSmoothed`
    bool isSmoothed = false;
    ivec2 picture{0}, view{0};  ///< pixels; 0: it is not stretched
    bool slicesInterpolated = false;
};

/// What only measuring tells the bias of: "march of 3 voxels, each iteration blurred". Empty: nothing.
Text shortcutNames(const BiasFacts& facts);
bool keepsRunningMean(const BiasFacts& facts);
bool sumsToATolerance(const BiasFacts& facts);
inline bool needsMeasuring(const BiasFacts& facts) {
    return !shortcutNames(facts).empty() || keepsRunningMean(facts) || sumsToATolerance(facts);
}

/// In the order of the causes. None of the computing: no bias is known there.
std::vector<Bias> biases(const BiasFacts& facts);
bool noneOfComputing(const std::vector<Bias>& biases);

}  // namespace pdr
