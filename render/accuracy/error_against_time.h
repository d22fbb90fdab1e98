#pragma once
/// The error that rendering time buys: with unbiased samples, and with samples that are blurred first, as in Exposure
/// Render. Errors are mean squared errors over the pixels, in any unit of radiance, the same for all.
///   variance   sigma^2, of one sample of a pixel, mean over the pixels        samples   n, per pixel, > 0

#include <span>

namespace pdr {

/// Returns the error of an unbiased image: sigma^2 / n.
double unbiasedError(double variance, double samples);

/// Returns kappa, the fraction of the variance that a separable filter leaves if the noise of neighbouring pixels is
/// independent: (sum w^2)^2 over the weights of one direction, whose sum is 1.
double remainingVariance(std::span<const double> weights);

/// Returns the error of an image in which every sample is filtered before it is added: B^2 + kappa sigma^2 / n. The
/// squared bias, B^2, stays however many samples there are.
double filteredError(double squaredBias, double remaining, double variance, double samples);

/// Returns the number of samples from which on the unbiased image is the better one for good:
/// sigma^2 (1 - kappa) / B^2. Infinite without bias.
double crossingSamples(double squaredBias, double remaining, double variance);

/// Returns the samples that bring an unbiased image to the root mean square error `target` (> 0): sigma^2 / target^2.
double samplesForError(double target, double variance);

/// Returns the time that samples take in whole frames of n iterations: ceil(samples / n) T.
double secondsForSamples(double samples, double iterationsPerFrame, double frameSeconds);

}  // namespace pdr
