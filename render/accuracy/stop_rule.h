#pragma once
/// When rendering stops by itself: at the first limit that is reached.

#include <cstdint>
#include <limits>

#include "render/accuracy/forecast.h"

namespace pdr {

/// Range of display levels that can be requested.
inline constexpr double kFinestTarget = 0.2, kCoarsestTarget = 64;
/// Returns the target nearest to `levels` that can be requested: a whole number from 3 on, tenths below, as
/// levelsText() shows them.
double nearestTarget(double levels);

/// Samples per pixel below which no error counts as reached, because too little is known of it.
inline constexpr std::uint64_t kSamplesToStop = 64;
/// Returns whether an error is as small as requested, for an image with so many samples in every pixel. This is the one
/// rule for window and command line, whatever the error's unit.
inline bool isReached(double error, double target, std::uint64_t samplesPerPixel) {
    return samplesPerPixel >= kSamplesToStop && error <= target;
}

struct StopRule {
    double levels = kFinestStep;                               ///< levels within which 95 % of the tissue lies, > 0
    double seconds = std::numeric_limits<double>::infinity();  ///< rendering time, > 0; infinite: no limit
    std::uint64_t samples = 0;                                 ///< samples per pixel; 0: no limit

    bool operator==(const StopRule&) const = default;

    /// Returns whether an image with that error, rendering time and samples meets the rule.
    bool isMet(double displayError, double secondsSpent, std::uint64_t samplesPerPixel) const {
        return isReached(displayError, levels, samplesPerPixel) || secondsSpent >= seconds ||
               (samples > 0 && samplesPerPixel >= samples);
    }
};

/// The limit that is predicted to be reached first.
struct ForetoldStop {
    enum class Cause { levels, seconds, samples } cause;
    double seconds = 0;  ///< total rendering time
    double levels = 0;   ///< error by then
    double samples = 0;  ///< samples per pixel by then
};

/// Predicts the stop of an image from its time and samples so far and the forecast of its steps; none without a
/// forecast.
std::optional<ForetoldStop> foretoldStop(const StopRule& rule, const std::vector<QualityStep>& steps,
                                         double secondsSpent, std::uint64_t samplesPerPixel);

}  // namespace pdr
