#pragma once
/// What accuracy costs in time: by samples that are right on average, and by samples that are blurred first, as
/// Exposure Render blurs them. Mean squared errors over the pixels; any unit of radiance, the same for all.
///   variance   sigma^2, of one sample of a pixel, mean over the pixels        samples   n, of each pixel, > 0

#include <span>

namespace pdr {

/// Of an unbiased picture: sigma^2 / n.
double unbiasedError(double variance, double samples);

/// The fraction of the variance that a separable filter leaves where its neighbours' noise is independent: (sum w^2)^2
/// over the weights of one direction, whose sum is 1.
double remainingVariance(std::span<const double> weights);

/// Of a picture whose every sample is filtered before it is added: B^2 + kappa sigma^2 / n. The squared bias, B^2,
/// stays however long one waits.
double filteredError(double squaredBias, double remaining, double variance, double samples);

/// From so many samples on the unbiased picture is the better one for good: sigma^2 (1 - kappa) / B^2. Infinite without
/// bias.
double crossingSamples(double squaredBias, double remaining, double variance);

/// Samples that bring an unbiased picture to the root mean square error `target` (> 0): sigma^2 / target^2.
double samplesForError(double target, double variance);

/// The time that they take in whole frames of n iterations: ceil(samples / n) T.
double secondsForSamples(double samples, double iterationsPerFrame, double frameSeconds);

}  // namespace pdr
