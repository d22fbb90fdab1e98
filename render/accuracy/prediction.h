#pragma once
/// What more accuracy would cost. The standard error of an unbiased picture falls with the root of the samples, so the
/// samples still to take follow from the error that is there: n* = n (e / e*)^2. Display levels fall at least as fast:
/// the tone curve is steepest where an interval reaches farthest down.

#include <optional>

#include "render/film/film_status.h"

namespace pdr {

/// Samples per pixel, in all, until the relative error is `target` (> 0). Infinite while the error is not known; the
/// samples that are there if it is reached already.
double samplesToReach(double target, const FilmStatus& status);

/// The same for an error of the display, in levels (> 0).
double samplesToReachLevels(double target, const FilmStatus& status);

/// The last of the steps below: what a screen shows has grey levels no finer.
inline constexpr double kFinestStep = 1;

/// A rounder, smaller error and the time until it is reached.
struct QualityStep {
    double levels;   ///< 95 % of the tissue within: 32, 16, 8, 4, 2 or 1
    double seconds;  ///< from now, at the speed of now
    bool atLeast;    ///< it rests on few bright samples: more time than that may be needed, hardly less
};

/// The next one. Nothing while too little is known to foretell it, without speed, or beyond the last step.
std::optional<QualityStep> nextQualityStep(const FilmStatus& status, double samplesPerSecond);

}  // namespace pdr
