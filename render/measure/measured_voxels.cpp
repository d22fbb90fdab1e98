#include "render/measure/measured_voxels.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "render/measure/trilinear.h"

namespace pdr::measure {
namespace {

/// What rounding may leave of a distance, in voxels or layers of them.
constexpr double kRounding = 1e-9;

/// A shape as the voxels see it.
struct Inside {
    std::function<bool(dvec3)> contains;  ///< whether a place [mm] is inside
    std::function<std::pair<double, double>(dvec3)>
        extent;          ///< lowest and highest dot product of its places with a vector
    dvec3 halfLayer{0};  ///< reach of a plane's layer of voxels to either side; 0: no plane [mm]
};

/// Returns whether a place lies in the layer about the plane through `origin`; of two layers side by side, in one. A
/// plane halfway between two takes the one against its normal, whole: rounding must not mix them.
bool inLayer(dvec3 mm, dvec3 origin, dvec3 normal, double thickness) {
    const double layer = std::floor(glm::dot(mm - origin, normal) / thickness + 0.5 + kRounding);
    return layer == 0;
}

std::pair<double, double> about(double middle, double half) {
    return {middle - half, middle + half};
}

Inside insideOf(const Ball& ball, const VolumeGeometry&) {
    return {[ball](dvec3 mm) { return glm::distance(mm, ball.centre) <= ball.radiusMm; },
            [ball](dvec3 v) { return about(glm::dot(v, ball.centre), ball.radiusMm * glm::length(v)); }};
}

Inside insideOf(const PlaneEllipse& ellipse, const VolumeGeometry& geometry) {
    const dvec3 normal = glm::normalize(glm::cross(ellipse.halfU, ellipse.halfV));
    const double thickness = layerMm(geometry, normal);
    return {[=](dvec3 mm) {
                const dvec3 away = mm - ellipse.centre;
                const double u = glm::dot(away, ellipse.halfU) / glm::dot(ellipse.halfU, ellipse.halfU),
                             v = glm::dot(away, ellipse.halfV) / glm::dot(ellipse.halfV, ellipse.halfV);
                return u * u + v * v <= 1 && inLayer(mm, ellipse.centre, normal, thickness);
            },
            [=](dvec3 v) {
                return about(glm::dot(v, ellipse.centre),
                             std::hypot(glm::dot(v, ellipse.halfU), glm::dot(v, ellipse.halfV)));
            },
            normal * (thickness / 2)};
}

/// Returns whether a line from a place in the plane crosses the outline an odd number of times.
bool enclosed(const PlanePolygon& polygon, dvec3 mm) {
    const dvec3 least = std::abs(polygon.normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 right = glm::normalize(glm::cross(least, polygon.normal)), up = glm::cross(polygon.normal, right);
    bool odd = false;
    dvec3 from = polygon.corners.back() - mm;
    for (const dvec3 corner : polygon.corners) {
        const dvec3 to = corner - mm;
        const double fromUp = glm::dot(from, up), toUp = glm::dot(to, up);
        if ((fromUp > 0) != (toUp > 0)) {
            const double share = fromUp / (fromUp - toUp);
            odd ^= std::lerp(glm::dot(from, right), glm::dot(to, right), share) > 0;
        }
        from = to;
    }
    return odd;
}

Inside insideOf(const PlanePolygon& polygon, const VolumeGeometry& geometry) {
    const double thickness = layerMm(geometry, polygon.normal);
    return {
        [=](dvec3 mm) { return inLayer(mm, polygon.corners[0], polygon.normal, thickness) && enclosed(polygon, mm); },
        [=](dvec3 v) {
            std::pair<double, double> extent{INFINITY, -INFINITY};
            for (const dvec3 corner : polygon.corners)
                extent = {std::min(extent.first, glm::dot(v, corner)), std::max(extent.second, glm::dot(v, corner))};
            return extent;
        },
        polygon.normal * (thickness / 2)};
}

}  // namespace

double layerMm(const VolumeGeometry& geometry, dvec3 normal) {
    const dmat3 step(geometry.patientFromIndex);
    return std::abs(glm::dot(normal, step[0])) + std::abs(glm::dot(normal, step[1])) +
           std::abs(glm::dot(normal, step[2]));
}

MeasuredVoxels voxelsIn(const Volume& volume, const MeasuredShape& shape) {
    const GridPlace grid(volume.geometry());
    const Inside inside = std::visit([&](const auto& each) { return insideOf(each, volume.geometry()); }, shape);
    MeasuredVoxels found;
    const dmat4 rows = glm::transpose(grid.indexFromPatient);
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = inside.extent(dvec3(rows[axis]));
        const double last = grid.size[axis] - 1, from = low + rows[axis].w, to = high + rows[axis].w;
        found.cut |= from < -0.5 - kRounding || to > last + 0.5 + kRounding;
        // Half a voxel more, so that rounding loses no centre on the border.
        const double more = std::abs(glm::dot(dvec3(rows[axis]), inside.halfLayer)) + 0.5;
        found.low[axis] = int(std::clamp(std::ceil(from - more), 0.0, last));
        found.high[axis] = int(std::clamp(std::floor(to + more), 0.0, last));
    }
    for (int k = found.low.z; k <= found.high.z; ++k)
        for (int j = found.low.y; j <= found.high.y; ++j)
            for (int i = found.low.x; i <= found.high.x; ++i) {
                const ivec3 voxel(i, j, k);
                if (!inside.contains(grid.mm(voxel)))
                    continue;
                if (volume.isPadding(grid.offset(voxel))) {
                    ++found.padding;
                    continue;
                }
                found.voxels.push_back(voxel);
                found.hu.push_back(volume.voxels()[grid.offset(voxel)]);
            }
    return found;
}

}  // namespace pdr::measure
