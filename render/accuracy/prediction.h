#pragma once
/// What more accuracy would cost. The standard error of an unbiased picture falls with the root of the samples, so the
/// samples still to take follow from the error that is there: n* = n (e / e*)^2.

#include <optional>

#include "render/film/film.h"

namespace pdr {

/// Samples a picture must have before its own estimate of its error is trusted for a forecast.
inline constexpr std::uint64_t kSamplesToPredict = 16;

/// Samples per pixel, in all, until the relative error is `target` (> 0). Infinite while the error is not known; the
/// samples that are there if it is reached already.
double samplesToReach(double target, const FilmStatus& status);

/// A rounder, smaller error and the time until it is reached.
struct QualityStep {
    double relativeError;  ///< 0.5, 0.2, 0.1, 0.05 ... 0.001
    double seconds;        ///< from now, at the speed of now
};

/// The next step down, or nothing: too few samples to tell, no speed, or already below the last one.
std::optional<QualityStep> nextQualityStep(const FilmStatus& status, double samplesPerSecond);

}  // namespace pdr
