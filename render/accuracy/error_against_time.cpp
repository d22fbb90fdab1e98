#include "render/accuracy/error_against_time.h"

#include <cmath>

namespace pdr {

double unbiasedError(double variance, double samples) {
    return variance / samples;
}

double remainingVariance(std::span<const double> weights) {
    double squares = 0;
    for (const double weight : weights)
        squares += weight * weight;
    return squares * squares;
}

double filteredError(double squaredBias, double remaining, double variance, double samples) {
    return squaredBias + remaining * unbiasedError(variance, samples);
}

double crossingSamples(double squaredBias, double remaining, double variance) {
    return variance * (1 - remaining) / squaredBias;
}

double samplesForError(double target, double variance) {
    return variance / (target * target);
}

double secondsForSamples(double samples, double iterationsPerFrame, double frameSeconds) {
    return std::ceil(samples / iterationsPerFrame) * frameSeconds;
}

}  // namespace pdr
