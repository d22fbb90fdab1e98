#pragma once
/// Scans of plates, balls and steps by formula, with the blur and the noise of a scanner. The truth is in the formula:
/// nothing of the program takes part in it. Lengths are millimetres, patient space.

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "render/volume/volume.h"

namespace pdr::test {

/// The scanner: a Gaussian point spread function along the axes of the grid, and noise with a Gaussian correlation
/// in the slice and none across, as filtered backprojection leaves it.
struct Scanner {
    dvec3 spacingMm;
    dvec3 blurMm;               ///< standard deviations of the point spread function
    double noiseHu = 0;         ///< standard deviation
    double noiseGrainMm = 0.7;  ///< standard deviation of the filter in the slice that makes the noise of white noise
    dvec2 driftMm{0};           ///< each slice from the one before, sideways, as with a tilted gantry
};

/// HU on either side of a border.
struct Contrast {
    double inside, outside;
};

using Normal = std::normal_distribution<double>;

inline dvec3 randomDirection(std::mt19937& random) {
    Normal normal;
    const double x = normal(random), y = normal(random);
    return glm::normalize(dvec3(x, y, normal(random)));
}

/// Returns a grid that covers `halfMm` to all sides of the origin, which lies anywhere within a voxel.
inline VolumeGeometry gridAround(const Scanner& scanner, double halfMm, std::mt19937& random) {
    const dvec2 sideways = glm::abs(scanner.driftMm) * std::ceil(halfMm / scanner.spacingMm.z);
    const ivec3 size = 2 * ivec3(glm::ceil((halfMm + dvec3(sideways, 0)) / scanner.spacingMm)) + 1;
    std::uniform_real_distribution<double> within(-0.5, 0.5);
    const double x = within(random), y = within(random);
    const dvec3 shift(x, y, within(random));
    VolumeGeometry geometry =
        VolumeGeometry::aligned(size, scanner.spacingMm, -scanner.spacingMm * (dvec3(size - 1) / 2.0 + shift));
    geometry.patientFromIndex[2] += dvec4(scanner.driftMm, 0, 0);
    geometry.patientFromIndex[3] -= dvec4(double(size.z - 1) / 2 * scanner.driftMm, 0, 0);
    return geometry;
}

/// Smooths along one axis of a grid with a Gaussian of `sigma` voxels, going round from the last voxel to the first:
/// equally everywhere.
inline void smoothAlong(std::vector<double>& values, ivec3 size, int axis, double sigma) {
    const int reach = int(std::ceil(4 * sigma));
    std::vector<double> weights;
    for (int n = -reach; n <= reach; ++n)
        weights.push_back(std::exp(-0.5 * n * n / (sigma * sigma)));
    const std::ptrdiff_t step = axis == 0 ? 1 : axis == 1 ? size.x : std::ptrdiff_t(size.x) * size.y;
    const std::vector<double> before = values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const int at = int(std::ptrdiff_t(i) / step % size[axis]);
        double sum = 0;
        for (int n = -reach; n <= reach; ++n)
            sum += weights[std::size_t(n + reach)] *
                   before[std::size_t(std::ptrdiff_t(i) + step * ((at + n + reach * size[axis]) % size[axis] - at))];
        values[i] = sum;
    }
}

/// Returns the noise of the scanner on a grid [HU], of the same standard deviation everywhere.
inline std::vector<double> noiseOn(ivec3 size, const Scanner& scanner, std::mt19937& random) {
    Normal normal;
    std::vector<double> noise(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (double& each : noise)
        each = normal(random);
    for (int axis = 0; axis < 2 && scanner.noiseGrainMm > 0; ++axis)
        smoothAlong(noise, size, axis, scanner.noiseGrainMm / scanner.spacingMm[axis]);
    // The filter is known, and so is what it leaves of a variance of 1.
    double scale = scanner.noiseHu;
    for (int axis = 0; axis < 2 && scanner.noiseGrainMm > 0; ++axis) {
        const double sigma = scanner.noiseGrainMm / scanner.spacingMm[axis];
        double squares = 0;
        for (int n = -int(std::ceil(4 * sigma)); n <= int(std::ceil(4 * sigma)); ++n)
            squares += std::exp(-n * n / (sigma * sigma));
        scale /= std::sqrt(squares);
    }
    for (double& each : noise)
        each *= scale;
    return noise;
}

/// Returns the scan of what has `hu` [HU] at each place, the blur in it, with the noise of the scanner.
inline Volume scanned(const VolumeGeometry& geometry, const Scanner& scanner, const std::function<double(dvec3)>& hu,
                      std::mt19937& random) {
    const std::vector<double> noise = noiseOn(geometry.size, scanner, random);
    Voxels voxels(geometry.voxelCount());
    std::size_t at = 0;
    for (int k = 0; k < geometry.size.z; ++k)
        for (int j = 0; j < geometry.size.y; ++j)
            for (int i = 0; i < geometry.size.x; ++i, ++at)
                voxels[at] =
                    std::int16_t(std::lround(hu(dvec3(geometry.patientFromIndex * dvec4(i, j, k, 1))) + noise[at]));
    return Volume(geometry, std::move(voxels));
}

/// Returns the standard deviation of the point spread function along a unit vector.
inline double blurAlong(const Scanner& scanner, dvec3 direction) {
    return glm::length(scanner.blurMm * direction);
}

/// Returns the share of a blurred half space at the distance `mm` inside its border.
inline double blurredStep(double mm, double blur) {
    return 0.5 * std::erfc(-mm / (blur * std::sqrt(2.0)));
}

/// Returns the scan of a plate of `thickness` whose middle plane runs through the origin across `normal`.
inline Volume scannedPlate(const Scanner& scanner, double thickness, dvec3 normal, Contrast hu, double halfMm,
                           std::mt19937& random) {
    const double blur = blurAlong(scanner, normal);
    return scanned(
        gridAround(scanner, halfMm, random), scanner,
        [&](dvec3 p) {
            const double depth = glm::dot(p, normal);
            const double share = blurredStep(thickness / 2 + depth, blur) - blurredStep(depth - thickness / 2, blur);
            return hu.outside + (hu.inside - hu.outside) * share;
        },
        random);
}

/// Returns the scan of a ball about the origin with equal blur along all axes, scanner.blurMm.x.
inline Volume scannedBall(const Scanner& scanner, double radius, Contrast hu, double halfMm, std::mt19937& random) {
    const double s = scanner.blurMm.x;
    return scanned(
        gridAround(scanner, halfMm, random), scanner,
        [&](dvec3 p) {
            // A ball convolved with a Gaussian, by its radial integral.
            const double r = std::max(glm::length(p), 1e-6), a = (radius - r) / s, b = (radius + r) / s;
            const double edge = std::exp(-0.5 * a * a) - std::exp(-0.5 * b * b);
            const double share = blurredStep(radius - r, s) + blurredStep(radius + r, s) - 1 -
                                 s / (r * std::sqrt(2 * std::acos(-1.0))) * edge;
            return hu.outside + (hu.inside - hu.outside) * share;
        },
        random);
}

}  // namespace pdr::test
