#pragma once
/// How much of a frame's time goes into samples. Perez Monte et al., "Estimation of Volume Rendering Efficiency with
/// GPU in a Parallel Distributed Environment", eqs 1 to 8, and a model that continues where they end.
///   all times in seconds       n, iterations   per displayed frame, >= 1
///   T_p   of one iteration     T_t   tone mapping of a frame        T_c   copies, launches and calls of a frame

#include <cstdint>

namespace pdr {

/// Times of the parts of a frame at one resolution.
struct FrameParts {
    double iteration;  ///< T_p
    double other;      ///< T_t + T_c
};

double efficiency(double n, const FrameParts& parts);           ///< eq. 1: E = n T_p / (n T_p + T_t + T_c)
double framesPerSecond(double n, const FrameParts& parts);      ///< eq. 2: FPS
double iterationsPerSecond(double n, const FrameParts& parts);  ///< eq. 3: IPS = n FPS

/// Eq. 4: E = 1 - FPS (T_t + T_c).
double efficiencyAtFrameRate(double framesPerSecond, double other);
/// Eq. 5, for a tile so small that T_t is negligible: E = 1 - FPS T_c. Optimistic: see optimismOfManyNodes().
double efficiencyOfManyNodes(double framesPerSecond, double communication);

/// Eq. 6: T_p from the frame rate at a large n. Too high by (T_t + T_c) / n.
double iterationFromFrameRate(double n, double framesPerSecond);
/// Eq. 7: T_t + T_c from the frame rate at n = 1. Negative if it is smaller than the error of the two measurements.
double otherFromFrameRate(double framesPerSecondOfOne, double iteration);
/// Eq. 8: T_c, by the formula of eq. 7 at a resolution so small that T_t is negligible.
double communicationFromFrameRate(double framesPerSecondOfOne, double iteration);

/// Work that is requested from a device for one frame.
struct FrameWork {
    double pixels;             ///< R, >= 1
    std::uint32_t iterations;  ///< n, >= 1
    std::uint32_t perLaunch;   ///< b, samples per pixel that one launch takes, >= 1

    std::uint32_t launches() const { return (iterations - 1) / perLaunch + 1; }
};

/// Model of a frame's time: T(R, n, b) = ceil(n / b) T0 + n alpha R + beta R + T_c. In the paper T_p is proportional to
/// the pixels; its own figures are not (46 ns a pixel at 1920 x 1080, 196 ns at 60 x 34): a launch takes at least T0,
/// however small its image.
struct FrameTimeModel {
    double launch = 0;         ///< T0
    double sample = 0;         ///< alpha, per sample of a pixel
    double pixel = 0;          ///< beta, per pixel of a frame
    double communication = 0;  ///< T_c, per frame
};

double frameSeconds(const FrameTimeModel& model, const FrameWork& work);
/// Returns the fraction of the time in which samples are taken at full speed: n alpha R / T. Launch times T0 count as
/// lost.
double sampleShare(const FrameTimeModel& model, const FrameWork& work);
/// Returns by how much eq. 5 exceeds sampleShare(): (ceil(n / b) T0 + beta R) / T.
double optimismOfManyNodes(const FrameTimeModel& model, const FrameWork& work);

}  // namespace pdr
