#pragma once
/// Patients with contrast medium in their blood, made by formula: of each voxel it is known whether it is a vessel.

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/support/scenes/noisy_scan.h"

namespace pdr::test {

/// Returns the distance of `place` from the way between two places [mm].
inline double distanceFromWay(const dvec3& place, const dvec3& a, const dvec3& b) {
    const dvec3 way = b - a;
    const double at = std::clamp(glm::dot(place - a, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::length(place - a - at * way);
}

/// A patient: where vessels are and the HU of everything else, without blur, by the place [mm].
struct VesselPhantom {
    std::function<bool(dvec3)> isPool;    ///< a great vessel
    std::function<bool(dvec3)> isBranch;  ///< a thin one
    double bloodHu = 0;
    std::function<double(dvec3)> restHu;
    std::function<bool(dvec3)> isUndiluted = [](dvec3) { return false; };  ///< a thin one full of undiluted medium

    bool isVessel(const dvec3& mm) const { return bloodHu > 0 && (isPool(mm) || isBranch(mm)); }
    double hu(const dvec3& mm) const { return isUndiluted(mm) ? 1200 : isVessel(mm) ? bloodHu : restHu(mm); }
};

/// A trunk of 45 mm radius along z with a spine: a shell of 800 HU around uneven marrow of 150 to 350 HU, 15 mm wide.
inline double trunkHu(const dvec3& mm) {
    const double spine = std::hypot(mm.x, mm.y - 28);
    if (spine < 13)
        return 250 + 100 * std::sin(1.1 * mm.x) * std::cos(1.3 * mm.y) * std::sin(0.9 * mm.z);
    if (spine < 15)
        return 800;
    return std::hypot(mm.x, mm.y) < 45 ? 50 : -1000;
}

/// An aorta of 10 mm radius, 3 mm from the spine, with branches of 3 and 2 mm radius into soft tissue.
inline VesselPhantom aortaBesideSpine() {
    return {[](dvec3 mm) { return std::hypot(mm.x, mm.y) < 10; },
            [](dvec3 mm) {
                return distanceFromWay(mm, {0, 0, 30}, {-35, -10, 45}) < 3 ||
                       distanceFromWay(mm, {0, 0, 60}, {32, -14, 75}) < 2;
            },
            350, trunkHu};
}

/// An artery of 3 mm radius that leaves the aorta and runs along the spine, whose shell it touches.
inline VesselPhantom arteryAlongBone() {
    return {[](dvec3 mm) { return std::hypot(mm.x, mm.y + 8) < 10; },
            [](dvec3 mm) {
                return distanceFromWay(mm, {-10, -8, 20}, {-18, 28, 40}) < 3 ||
                       distanceFromWay(mm, {-18, 28, 40}, {-18, 28, 80}) < 3;
            },
            420, trunkHu};
}

/// A pool of 10 mm radius between two lungs of -850 HU with vessels of 1.5 and 2.5 mm radius, which are not connected
/// with the pool in the scan.
inline VesselPhantom lungVessels() {
    return {[](dvec3 mm) { return std::hypot(mm.x, mm.y + 3) < 10; },
            [](dvec3 mm) {
                const dvec3 aside(std::abs(mm.x), mm.y, mm.z);
                return distanceFromWay(aside, {36, -12, 30}, {36, 0, 75}) < 2.5 ||
                       distanceFromWay(aside, {30, 4, 30}, {38, 10, 70}) < 1.5;
            },
            330,
            [](dvec3 mm) {
                const dvec3 in((std::abs(mm.x) - 36) / 21, (mm.y + 2) / 28, (mm.z - 50) / 120);
                if (glm::length(in) < 1)
                    return -850.0;
                return std::hypot(mm.x / 1.38, mm.y) < 48 ? 50.0 : -1000.0;
            }};
}

/// A vein of 6 mm radius full of undiluted medium, between the pool of such lungs and a bone whose shell has 900 HU;
/// and behind the pool, bone that is as solid as the vein.
inline VesselPhantom undilutedVein() {
    const VesselPhantom lungs = lungVessels();
    const auto vein = [](dvec3 mm) { return distanceFromWay(mm, {-12, -20, 20}, {10, -20, 85}) < 6; };
    const auto restHu = [rest = lungs.restHu](dvec3 mm) {
        const double shell = std::hypot(mm.x, mm.y + 35);
        return std::hypot(mm.x, mm.y - 34) < 6 ? 1100.0 : shell < 4 ? 250.0 : shell < 6 ? 900.0 : rest(mm);
    };
    return {lungs.isPool, vein, lungs.bloodHu, restHu, vein};
}

/// Returns a scan of a phantom: 160 x 120 x 72 voxels of 0.85 x 0.85 x 1.4 mm, each the mean of 8 places, with noise of
/// 20 HU.
inline Volume scanOf(const VesselPhantom& phantom) {
    const VolumeGeometry geometry = VolumeGeometry::aligned({160, 120, 72}, {0.85, 0.85, 1.4}, {-67.6, -50.6, 0});
    return noisyScan(geometry, 20, [&](const dvec3& mm) { return phantom.hu(mm); });
}

}  // namespace pdr::test
