#pragma once
/// How many iterations one displayed frame should have. After Perez Monte et al., "Estimation of Volume Rendering
/// Efficiency with GPU in a Parallel Distributed Environment", eqs 1 and 2.
///   iterationSeconds  T_p, time of one iteration       otherSeconds  T_t + T_c, time of a frame beside its iterations

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pdr {

inline constexpr std::uint32_t kMostIterationsPerFrame = 10000;

/// Returns `wanted` as a number of iterations, [1, kMostIterationsPerFrame]; 1 if it is not a number.
inline std::uint32_t allowedIterations(double wanted) {
    if (!(wanted > 1))
        return 1;
    return std::uint32_t(std::min(wanted, double(kMostIterationsPerFrame)));
}

/// Returns the fewest iterations with which a frame spends the fraction `efficiency`, [0, 1), of its time on
/// iterations: eq. 1 solved for n, n >= E / (1 - E) (T_t + T_c) / T_p. Returns the most that are allowed if iterations
/// take no time.
inline std::uint32_t iterationsForEfficiency(double efficiency, double iterationSeconds, double otherSeconds) {
    if (!(otherSeconds > 0) || !(efficiency > 0))
        return 1;
    if (!(iterationSeconds > 0) || efficiency >= 1)
        return kMostIterationsPerFrame;
    const double exact = efficiency / (1 - efficiency) * otherSeconds / iterationSeconds;
    return allowedIterations(std::ceil(exact * (1 - 1e-12)));  // 0.9 / 0.1 is a little more than 9
}

/// Returns the most iterations with which frames still come `framesPerSecond` times a second (> 0), eq. 2; 1 if not
/// even one fits in.
inline std::uint32_t iterationsForFrameRate(double framesPerSecond, double iterationSeconds, double otherSeconds) {
    const double left = 1 / framesPerSecond - otherSeconds;
    if (!(left > 0))
        return 1;
    if (!(iterationSeconds > 0))
        return kMostIterationsPerFrame;
    return allowedIterations(std::floor(left / iterationSeconds * (1 + 1e-12)));
}

/// Least fraction of the time that goes into iterations in frames that come too late anyway, as denoised ones may.
inline constexpr double kLateEfficiency = 0.8;

/// Returns as many iterations as `targetEfficiency` requires, but no more than `framesPerSecond` allows. If not even
/// one is fast enough for that rate, returns as many as kLateEfficiency requires.
inline std::uint32_t iterationsPerFrame(double targetEfficiency, double framesPerSecond, double iterationSeconds,
                                        double otherSeconds) {
    if (iterationSeconds > 0 && iterationSeconds + otherSeconds > 1 / framesPerSecond)
        return iterationsForEfficiency(std::min(targetEfficiency, kLateEfficiency), iterationSeconds, otherSeconds);
    return std::min(iterationsForEfficiency(targetEfficiency, iterationSeconds, otherSeconds),
                    iterationsForFrameRate(framesPerSecond, iterationSeconds, otherSeconds));
}

}  // namespace pdr
