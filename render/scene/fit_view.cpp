#include "render/scene/fit_view.h"

#include <algorithm>
#include <cmath>

#include "render/scene/perspective.h"

namespace pdr {
namespace {

/// Returns the corners of the box of all voxels, voxel extents included [mm].
std::vector<dvec3> cornersMm(const VolumeGeometry& geometry) {
    std::vector<dvec3> corners;
    for (int i = 0; i < 8; ++i) {
        const dvec3 end(i & 1, (i >> 1) & 1, i >> 2);
        corners.emplace_back(geometry.patientFromIndex * dvec4(end * dvec3(geometry.size) - 0.5, 1.0));
    }
    return corners;
}

Camera nearest(const Camera& camera, const std::vector<dvec3>& places, double aspect, double fraction) {
    const double slopeUp = heightPerDepth(camera.fovDegrees) / 2 * fraction;
    const double slopeRight = slopeUp * aspect;
    const dvec3 right = camera.right(), up = camera.imageUp(), forward = camera.forward();
    double distance = 0, height = 0;
    for (const dvec3& place : places) {
        const dvec3 offset = place - camera.targetMm;
        const double x = std::abs(glm::dot(offset, right));
        const double y = std::abs(glm::dot(offset, up));
        const double depth = glm::dot(offset, forward);
        distance = std::max({distance, x / slopeRight - depth, y / slopeUp - depth});
        height = std::max({height, 2 * x / aspect / fraction, 2 * y / fraction});
    }
    Camera result = camera;
    result.heightMm = height;
    result.eyeMm = camera.targetMm - forward * distance;
    return result;
}

/// Largest thickness of a slab, relative to its other edges; seen from the side, a thinner volume is only a bar.
constexpr double kThin = 1.0 / 3;

}  // namespace

StandardView firstView(const VolumeGeometry& geometry) {
    const dvec3 edges = geometry.spacingMm() * dvec3(geometry.size);
    for (int axis = 0; axis < 3; ++axis) {
        if (edges[axis] >= kThin * std::min(edges[(axis + 1) % 3], edges[(axis + 2) % 3]))
            continue;
        const dvec3 across = glm::abs(dvec3(geometry.patientFromIndex[axis]));
        if (across.x > across.y && across.x > across.z)
            return StandardView::left;
        if (across.z > across.y)
            return StandardView::inferior;
    }
    return StandardView::anterior;
}

Camera fittedView(const Camera& camera, const VolumeGeometry& geometry, double aspect, double fraction) {
    return nearest(camera, cornersMm(geometry), aspect, fraction);
}

Camera fittedView(StandardView view, const Framed& framed, double aspect, double fraction, const Camera& lens) {
    Camera camera = standardView(view, framed.box.centreMm(), framed.box.radiusMm(), aspect);
    camera.type = lens.type;
    camera.fovDegrees = lens.fovDegrees;
    camera.apertureMm = lens.apertureMm;
    return nearest(camera, framed.placesMm ? *framed.placesMm : cornersMm(framed.box), aspect, fraction);
}

}  // namespace pdr
