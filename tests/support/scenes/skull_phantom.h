#pragma once
/// A skull made by formula, whose plane of symmetry and whose hole are known.

#include <cmath>
#include <numbers>
#include <utility>

#include "tests/support/scenes/noisy_scan.h"

namespace pdr::test {

/// A shell of bone of 6 mm around a brain, with a nose and two sockets, in soft tissue. Its own axes: x to its left, y
/// to its back, z to its top, from its middle.
struct SkullPhantom {
    double holeMm = 0;     ///< radius of a round hole in one side; 0: none
    double holeSide = -1;  ///< its side: -1 right, 1 left
    bool isHalf = false;   ///< whether its left side has no bone
    double boneHu = 900;
    dvec3 middleMm{7, -4, 3};

    /// Returns its axes in patient space: 5 degrees askew about z, and 3 about y.
    static dmat3 axes() {
        constexpr double kYaw = 5 * std::numbers::pi / 180, kRoll = 3 * std::numbers::pi / 180;
        const dmat3 yaw(std::cos(kYaw), std::sin(kYaw), 0, -std::sin(kYaw), std::cos(kYaw), 0, 0, 0, 1);
        const dmat3 roll(std::cos(kRoll), 0, std::sin(kRoll), 0, 1, 0, -std::sin(kRoll), 0, std::cos(kRoll));
        return yaw * roll;
    }
    dvec3 normal() const { return axes()[0]; }

    double hu(const dvec3& mm) const {
        const dvec3 at = glm::transpose(axes()) * (mm - middleMm);
        const dvec3 half(58, 70, 55);
        const double shell = (1 - glm::length(at / half)) * 60;  // depth below the outer table, about mm
        const double nose = glm::length((at - dvec3(0, -72, -14)) / dvec3(9, 9, 16));
        const double socket = glm::length((dvec3(std::abs(at.x), at.y, at.z) - dvec3(26, -62, -8)) / dvec3(15, 22, 13));
        if (shell < -9)
            return nose < 1 ? boneHu : -1000;
        if (socket < 1)
            return 30;
        const dvec2 fromHole(at.y - 6, at.z - 14);
        const bool isHole = (at.x * holeSide > 0 && glm::length(fromHole) < holeMm) || (isHalf && at.x > 0);
        if ((shell >= 0 && shell < 6 && !isHole) || nose < 1)
            return boneHu;
        return 40;
    }
};

/// Returns a scan of it: 112 x 136 x 78 voxels of 1.3 x 1.3 x 1.8 mm, each the mean of 8 places, with noise of 15 HU.
inline Volume scanOf(const SkullPhantom& skull) {
    const VolumeGeometry geometry = VolumeGeometry::aligned({112, 136, 78}, {1.3, 1.3, 1.8}, {-65.2, -94, -66.3});
    return noisyScan(geometry, 15, [&](const dvec3& mm) { return skull.hu(mm); });
}

}  // namespace pdr::test
