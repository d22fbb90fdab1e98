#pragma once
/// How many iterations one displayed frame should hold. After Perez Monte et al., "Estimation of Volume Rendering
/// Efficiency with GPU in a Parallel Distributed Environment", eqs 1 and 2.
///   iterationSeconds  T_p, of one iteration             otherSeconds  T_t + T_c, of a frame beside its iterations

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pdr {

inline constexpr std::uint32_t kMostIterationsPerFrame = 10000;

/// `wanted` as a number of iterations, [1, kMostIterationsPerFrame]; 1 where it is not a number.
inline std::uint32_t allowedIterations(double wanted) {
    if (!(wanted > 1))
        return 1;
    return std::uint32_t(std::min(wanted, double(kMostIterationsPerFrame)));
}

/// The fewest iterations with which a frame spends `efficiency` in [0, 1) of its time on iterations: eq. 1 solved for
/// n, n >= E / (1 - E) (T_t + T_c) / T_p. The most that are allowed where iterations take no time.
inline std::uint32_t iterationsForEfficiency(double efficiency, double iterationSeconds, double otherSeconds) {
    if (!(otherSeconds > 0) || !(efficiency > 0))
        return 1;
    if (!(iterationSeconds > 0) || efficiency >= 1)
        return kMostIterationsPerFrame;
    const double exact = efficiency / (1 - efficiency) * otherSeconds / iterationSeconds;
    return allowedIterations(std::ceil(exact * (1 - 1e-12)));  // 0.9 / 0.1 is a little more than 9
}

/// The most iterations with which frames still come `framesPerSecond` times a second (> 0), eq. 2; 1 where not even one
/// fits in.
inline std::uint32_t iterationsForFrameRate(double framesPerSecond, double iterationSeconds, double otherSeconds) {
    const double left = 1 / framesPerSecond - otherSeconds;
    if (!(left > 0))
        return 1;
    if (!(iterationSeconds > 0))
        return kMostIterationsPerFrame;
    return allowedIterations(std::floor(left / iterationSeconds * (1 + 1e-12)));
}

/// Of frames that come too late anyway, as smoothed ones may: the part of the time that goes into iterations at least.
inline constexpr double kLateEfficiency = 0.8;

/// As many as `targetEfficiency` asks for, but no more than leave `framesPerSecond`; where not even one leaves that, as
/// many as kLateEfficiency asks for.
inline std::uint32_t iterationsPerFrame(double targetEfficiency, double framesPerSecond, double iterationSeconds,
                                        double otherSeconds) {
    if (iterationSeconds > 0 && iterationSeconds + otherSeconds > 1 / framesPerSecond)
        return iterationsForEfficiency(std::min(targetEfficiency, kLateEfficiency), iterationSeconds, otherSeconds);
    return std::min(iterationsForEfficiency(targetEfficiency, iterationSeconds, otherSeconds),
                    iterationsForFrameRate(framesPerSecond, iterationSeconds, otherSeconds));
}

}  // namespace pdr
