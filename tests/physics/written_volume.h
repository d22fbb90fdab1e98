#pragma once
/// A volume between its voxels and rays through it, once more and in double precision; nothing is shared with
/// render/kernel. Lengths are millimetres, places are patient space.

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/scene/clip.h"
#include "render/volume/volume.h"
#include "tests/physics/gauss_legendre.h"
#include "tests/physics/written_optics.h"

namespace pdr::test::written {

/// A ray, and the part of it that counts.
struct Line {
    dvec3 origin, direction;
    double from, to;
    dvec3 at(double t) const { return origin + direction * t; }
};

/// Trilinear between voxel centres, constant beyond the outermost ones; any grid, oblique ones too.
class Grid {
  public:
    explicit Grid(const Volume& volume)
        : voxels_(volume.voxels()),
          size_(volume.size()),
          indexFromPatient_(glm::inverse(volume.geometry().patientFromIndex)),
          covariant_(glm::transpose(glm::inverse(dmat3(volume.geometry().patientFromIndex)))) {}

    dvec3 index(dvec3 place) const { return dvec3(indexFromPatient_ * dvec4(place, 1)); }
    dvec3 alongIndex(dvec3 direction) const { return dvec3(indexFromPatient_ * dvec4(direction, 0)); }
    /// The normal, in index space, of a plane with this one in patient space, and as long as a step of one voxel across
    /// it is in millimetres where `normal` is a unit vector.
    dvec3 acrossIndex(dvec3 normal) const { return glm::inverse(covariant_) * normal; }
    ivec3 size() const { return size_; }

    /// Returns the HU at an index, with the weights of the eight voxels around.
    double hu(dvec3 index) const {
        ivec3 low, high;
        dvec3 fraction;
        for (int axis = 0; axis < 3; ++axis) {
            const double x = std::clamp(index[axis], 0.0, double(size_[axis] - 1));
            low[axis] = int(x);
            high[axis] = std::min(low[axis] + 1, size_[axis] - 1);
            fraction[axis] = x - low[axis];
        }
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const bool i = corner & 1, j = corner & 2, k = corner & 4;
            const double weight = (i ? fraction.x : 1 - fraction.x) * (j ? fraction.y : 1 - fraction.y) *
                                  (k ? fraction.z : 1 - fraction.z);
            sum += weight * voxel(i ? high.x : low.x, j ? high.y : low.y, k ? high.z : low.z);
        }
        return sum;
    }

    /// [HU/mm], patient space.
    dvec3 gradient(dvec3 index) const {
        return gradientOf(index, [&](ivec3 at) { return voxel(at.x, at.y, at.z); });
    }

    /// [1/mm], patient space: of the cubic B-spline that has value(voxel) as coefficients, by the chain rule. Voxels
    /// are repeated beyond the borders.
    template <class Value>
    dvec3 gradientOf(dvec3 index, Value&& value) const {
        const ivec3 corner(glm::floor(index));
        dvec3 perVoxel(0);
        for (int n = 0; n < 64; ++n) {
            const ivec3 at = corner + ivec3(n % 4, n / 4 % 4, n / 16) - 1;
            const dvec3 away = index - dvec3(at), share(spline(away.x), spline(away.y), spline(away.z));
            const ivec3 nearest = glm::clamp(at, ivec3(0), size_ - 1);
            perVoxel +=
                value(nearest) * dvec3(splineSlope(away.x) * share.y * share.z, share.x * splineSlope(away.y) * share.z,
                                       share.x * share.y * splineSlope(away.z));
        }
        return covariant_ * perVoxel;
    }

  private:
    /// The cubic B-spline: (|x + 2|^3 - 4 |x + 1|^3 + 6 |x|^3 - 4 |x - 1|^3 + |x - 2|^3) / 12; and its derivative.
    static double spline(double x) {
        const auto cube = [](double d) { return std::fabs(d) * d * d; };
        return (cube(x + 2) - 4 * cube(x + 1) + 6 * cube(x) - 4 * cube(x - 1) + cube(x - 2)) / 12;
    }
    static double splineSlope(double x) {
        const auto square = [](double d) { return std::fabs(d) * d; };
        return (square(x + 2) - 4 * square(x + 1) + 6 * square(x) - 4 * square(x - 1) + square(x - 2)) / 4;
    }

    double voxel(int i, int j, int k) const { return voxels_[(std::size_t(k) * size_.y + j) * size_.x + i]; }

    std::span<const std::int16_t> voxels_;
    ivec3 size_;
    dmat4 indexFromPatient_;
    dmat3 covariant_;
};

/// The part of a line inside the box of all voxels.
inline Line inBox(const Grid& grid, Line line) {
    const dvec3 origin = grid.index(line.origin), direction = grid.alongIndex(line.direction);
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (-0.5 - origin[axis]) / direction[axis];
        const double b = (grid.size()[axis] - 0.5 - origin[axis]) / direction[axis];
        line.from = std::max(line.from, std::min(a, b));
        line.to = std::min(line.to, std::max(a, b));
    }
    return line;
}

/// The part of a line that no plane cuts away.
inline Line uncut(const std::vector<ClipPlane>& planes, Line line) {
    for (const ClipPlane& plane : planes) {
        const double closing = glm::dot(plane.normal, line.direction);
        const double t = glm::dot(plane.normal, plane.pointMm - line.origin) / closing;
        if (closing > 0)
            line.to = std::min(line.to, t);
        else
            line.from = std::max(line.from, t);
    }
    return line;
}

/// Where a line's optics have kinks or steps, ascending, both its ends among them: the planes of voxel centres, and
/// where the HU pass a node of the curve. In between HU are a cubic and the extinction is linear in them.
inline std::vector<double> kinks(const Grid& grid, const std::vector<TransferNode>& nodes, const Line& line) {
    const dvec3 origin = grid.index(line.origin), direction = grid.alongIndex(line.direction);
    std::vector<double> planes{line.from, line.to};
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < grid.size()[axis]; ++i)
            if (const double t = (i - origin[axis]) / direction[axis]; t > line.from && t < line.to)
                planes.push_back(t);
    std::sort(planes.begin(), planes.end());
    std::vector<double> all{line.from};
    constexpr int kParts = 6;
    const auto hu = [&](double t) { return grid.hu(origin + direction * t); };
    for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
        double before = planes[i], huBefore = hu(before);
        for (int part = 1; part <= kParts; ++part) {
            const double here = planes[i] + (planes[i + 1] - planes[i]) * part / kParts, huHere = hu(here);
            const std::size_t first = all.size();
            for (const TransferNode& node : nodes) {
                if ((huBefore < node.hu) == (huHere < node.hu))
                    continue;
                double low = before, high = here;
                for (int halving = 0; halving < 48; ++halving) {
                    const double middle = (low + high) / 2;
                    ((hu(middle) < node.hu) == (huBefore < node.hu) ? low : high) = middle;
                }
                all.push_back((low + high) / 2);
            }
            std::sort(all.begin() + std::ptrdiff_t(first), all.end());
            before = here;
            huBefore = huHere;
        }
        all.push_back(planes[i + 1]);
    }
    return all;
}

/// Optical depth between two neighbouring kinks or part of that way. Two points are exact for a cubic, four for the
/// product of two.
template <int kPoints, class Extinction>
double depthOf(double from, double to, Extinction&& extinction) {
    static const std::vector<QuadraturePoint> points = gaussLegendre(kPoints);
    double sum = 0;
    for (const QuadraturePoint& point : points)
        sum += point.weight * extinction(from + (to - from) * point.at);
    return sum * (to - from);
}

}  // namespace pdr::test::written
