#include "render/volume/phantom.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

constexpr double kAir = -1000, kFat = -90, kSkin = 30, kMuscle = 55, kBrain = 36, kWater = 8, kLens = 40;
constexpr double kTable = 1350, kDiploe = 550, kTeeth = 2300;
constexpr double kNoiseHu = 6;
constexpr double kDrawnForMm = 250;

/// Returns about the distance to an ellipsoid's surface [mm], negative inside: f / |grad f|, exact to first order
/// there.
double ellipsoid(const dvec3& p, const dvec3& centre, const dvec3& radii) {
    const dvec3 q = (p - centre) / radii;
    const double scaled = glm::length(q);
    if (scaled < 1e-9)
        return -std::min({radii.x, radii.y, radii.z});
    return scaled * (scaled - 1.0) / glm::length(q / radii);
}

/// Returns the distance to two ellipsoids, one on either side of the patient.
double pair(const dvec3& p, const dvec3& centre, const dvec3& radii) {
    return ellipsoid(dvec3(std::abs(p.x), p.y, p.z), centre, radii);
}

/// Returns the distance to an endless cylinder through `through` along `axis` (unit length).
double cylinder(const dvec3& p, const dvec3& through, const dvec3& axis, double radius) {
    const dvec3 q = p - through;
    return glm::length(q - axis * glm::dot(q, axis)) - radius;
}

/// Returns the distance to a union with a rounded seam, `width` mm wide.
double joined(double a, double b, double width) {
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - h * h * width * 0.25;
}

/// The head at one point, painted from the outside in; every border is soft over one voxel, as in a scanner's image.
class Painter {
  public:
    Painter(const dvec3& point, double softnessMm) : p_(point), softness_(softnessMm) {}

    double hu() {
        const dvec3 cranialCentre(0, 8, 28);
        const double cranium = ellipsoid(p_, cranialCentre, {74, 92, 84});
        const double face = ellipsoid(p_, {0, -22, -48}, {56, 66, 62});
        const double neck = std::max(cylinder(p_, {0, 22, 0}, {0, 0, 1}, 50), p_.z + 20);
        const double nose = ellipsoid(p_, {0, -88, -38}, {13, 20, 20});
        const double skin = joined(joined(joined(cranium, face, 25), neck, 30), nose, 12);
        if (skin > 2 * softness_)
            return kAir;
        paint(skin, kSkin);
        paint(skin + 2.5, kFat);
        paint(skin + 5, kMuscle);
        paintFace(face);
        paintCranium(cranium, cranialCentre);
        paintCavities();
        return hu_;
    }

  private:
    void paint(double distance, double hu) {
        const double covered = std::clamp(0.5 - distance / softness_, 0.0, 1.0);
        hu_ += covered * (hu - hu_);
    }

    void paintFace(double face) {
        const double front = p_.y + 25;  // the facial bones lie before this plane
        paint(std::max(face + 11, front), kTable);
        paint(std::max(face + 13.5, front), kDiploe);
        paint(std::max(face + 22, front), kMuscle);
        paint(std::max({std::abs(face + 15) - 4.5, std::abs(p_.z + 74) - 9, p_.y + 50}), kTeeth);
        paint(std::max(cylinder(p_, {0, 42, 0}, {0, 0, 1}, 17), p_.z + 52), kTable);
        paint(std::max(cylinder(p_, {0, 42, 0}, {0, 0, 1}, 14), p_.z + 52), kDiploe);
    }

    void paintCranium(double cranium, const dvec3& centre) {
        const dvec3 toDefect = glm::normalize(dvec3(-0.62, -0.5, 0.6));
        const bool onDefectSide = glm::dot(p_ - centre, toDefect) > 0;
        const double defect = onDefectSide ? cylinder(p_, centre, toDefect, 27) : 1e3;
        paint(std::max(cranium + 7, -defect), kTable);
        paint(std::max(cranium + 9, -defect), kDiploe);
        paint(std::max(cranium + 12, -defect), kTable);
        paint(cranium + 14.5, kWater);
        paint(cranium + 16.5, kBrain);
        paint(pair(p_, {13, 2, 38}, {7, 32, 12}), kWater);
    }

    void paintCavities() {
        paint(pair(p_, {31, -46, -4}, {20, 22, 18}), kTable);
        paint(pair(p_, {31, -47, -4}, {18, 21, 16}), kFat);
        paint(pair(p_, {31, -56, -4}, {12, 12, 12}), kWater);
        paint(pair(p_, {31, -64, -4}, {5, 2.5, 5}), kLens);
        paint(ellipsoid(p_, {0, -72, 22}, {20, 4, 9}), kAir);
        paint(pair(p_, {28, -58, -42}, {14, 16, 17}), kAir);
        paint(ellipsoid(p_, {0, -72, -38}, {11, 26, 20}), kAir);
        paint(std::max(ellipsoid(p_, {0, -72, -38}, {13, 28, 22}), std::abs(p_.x) - 1), kTable);
        paint(std::max(cylinder(p_, {0, 5, 0}, {0, 0, 1}, 9), p_.z + 45), kAir);
        paint(pair(p_, {60, 22, -22}, {24, 3.5, 3.5}), kAir);
    }

    dvec3 p_;
    double softness_;
    double hu_ = kAir;
};

/// Applies splitmix64: one well-mixed word for each input. Steele, Lea & Flood 2014.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    return x ^ x >> 31;
}

/// Returns nearly normal noise, mean 0, deviation 1: the scaled sum of four 16-bit uniforms.
double noiseAt(std::uint64_t seed, std::size_t index) {
    const std::uint64_t bits = mixed(mixed(seed) ^ index);
    double sum = 0;
    for (int part = 0; part < 4; ++part)
        sum += double(bits >> 16 * part & 0xFFFF) / 65536.0 - 0.5;
    return sum * std::sqrt(3.0);
}

}  // namespace

Volume headPhantom(ivec3 size, dvec3 spacingMm, std::uint64_t seed) {
    const dvec3 box = dvec3(size) * spacingMm;
    const double scale = kDrawnForMm / std::min({box.x, box.y, box.z});
    const double softness = scale * std::min({spacingMm.x, spacingMm.y, spacingMm.z});
    const VolumeGeometry geometry = VolumeGeometry::aligned(size, spacingMm, -0.5 * (dvec3(size) - 1.0) * spacingMm);
    Voxels voxels(geometry.voxelCount());
    tbb::parallel_for(0, size.z, [&](int z) {
        std::size_t index = std::size_t(z) * std::size_t(size.x) * std::size_t(size.y);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++index) {
                const dvec3 point = dvec3(geometry.patientFromIndex * dvec4(x, y, z, 1)) * scale;
                const double hu = Painter(point, softness).hu() + kNoiseHu * noiseAt(seed, index);
                voxels[index] = std::int16_t(std::clamp(std::round(hu), -1024.0, 3071.0));
            }
        }
    });
    return Volume(geometry, std::move(voxels));
}

}  // namespace pdr
