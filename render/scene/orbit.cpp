#include "render/scene/orbit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/scene/perspective.h"

namespace pdr {
namespace {

constexpr double kNearestMm = 1;     ///< smallest distance of the eye from the target
constexpr double kFarthestMm = 1e6;  ///< largest distance: beyond it, a volume is smaller than a pixel

/// Returns the height of the visible area at the target's depth [mm].
double seenHeightMm(const Camera& camera) {
    if (camera.type == Camera::Type::orthographic)
        return camera.heightMm;
    return glm::length(camera.targetMm - camera.eyeMm) * heightPerDepth(camera.fovDegrees);
}

}  // namespace

/// Applies Rodrigues' rotation formula.
dvec3 turned(dvec3 v, dvec3 axis, double angle) {
    const double c = std::cos(angle);
    return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1 - c));
}

/// Rotates eye and up vector together about one axis of the image plane, so no direction is special and there is no
/// pole. The axes are made orthogonal again each time, so rounding errors do not add up.
Camera orbited(const Camera& camera, dvec2 drag) {
    const double length = glm::length(drag);
    if (length == 0)
        return camera;
    const dvec3 up = camera.imageUp();
    const dvec3 axis = glm::normalize(up * -drag.x + camera.right() * -drag.y);
    const double angle = length * kHalfTurn;
    const dvec3 forward = glm::normalize(turned(camera.forward(), axis, angle));
    const dvec3 turnedUp = turned(up, axis, angle);

    Camera result = camera;
    result.up = glm::normalize(turnedUp - forward * glm::dot(forward, turnedUp));
    result.eyeMm = camera.targetMm - forward * glm::length(camera.targetMm - camera.eyeMm);
    return result;
}

Camera panned(const Camera& camera, dvec2 drag) {
    const dvec3 shift = (camera.imageUp() * drag.y - camera.right() * drag.x) * seenHeightMm(camera);
    Camera result = camera;
    result.eyeMm += shift;
    result.targetMm += shift;
    return result;
}

Camera zoomed(const Camera& camera, double factor) {
    assert(factor > 0);
    Camera result = camera;
    if (camera.type == Camera::Type::orthographic) {
        result.heightMm = std::clamp(camera.heightMm / factor, kNearestMm, kFarthestMm);
        return result;
    }
    const double distance = glm::length(camera.targetMm - camera.eyeMm);
    const double wanted = std::clamp(distance / factor, kNearestMm, std::max(kFarthestMm, distance));
    result.eyeMm = camera.targetMm - camera.forward() * wanted;
    if (camera.focusMm > 0)  // the sharp plane stays where it is
        result.focusMm = std::max(camera.focusMm + wanted - distance, kNearestMm);
    return result;
}

}  // namespace pdr
