#pragma once
/// When rendering holds by itself: whichever comes first.

#include <cstdint>
#include <limits>

#include "render/accuracy/forecast.h"

namespace pdr {

/// Display levels that can be asked for.
inline constexpr double kFinestTarget = 0.2, kCoarsestTarget = 64;
/// The nearest that can be, whole ones from 3 on and tenths below, as they are said (levelsText()).
double nearestTarget(double levels);

/// Samples per pixel below which no error counts as reached: too little is known of it.
inline constexpr std::uint64_t kSamplesToStop = 64;
/// Whether an error is as small as was asked for, by a picture that has so many samples in every pixel. The one rule,
/// for window and command line, whatever the error's unit.
inline bool isReached(double error, double target, std::uint64_t samplesPerPixel) {
    return samplesPerPixel >= kSamplesToStop && error <= target;
}

struct StopRule {
    double levels = kFinestStep;                               ///< 95 % of the tissue within so many, > 0
    double seconds = std::numeric_limits<double>::infinity();  ///< of rendering, > 0; infinite: no limit
    std::uint64_t samples = 0;                                 ///< of every pixel; 0: no limit

    bool operator==(const StopRule&) const = default;

    /// Whether a picture of that error that has got so much is as good as was asked for.
    bool isMet(double displayError, double secondsSpent, std::uint64_t samplesPerPixel) const {
        return isReached(displayError, levels, samplesPerPixel) || secondsSpent >= seconds || (samples > 0 && samplesPerPixel >= samples);
    }
};

/// What comes first, as it is foretold.
struct ForetoldStop {
    enum class Cause { levels, seconds, samples } cause;
    double seconds = 0;  ///< of rendering, in all
    double levels = 0;   ///< of the error by then
    double samples = 0;  ///< of every pixel by then
};

/// Of a picture that has got so much and whose steps are foretold; none where nothing is.
std::optional<ForetoldStop> foretoldStop(const StopRule& rule, const std::vector<QualityStep>& steps,
                                         double secondsSpent, std::uint64_t samplesPerPixel);

}  // namespace pdr
