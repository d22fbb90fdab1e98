#include "render/scene/edit/camera_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/scene/perspective.h"

namespace pdr {
namespace {

constexpr double kNearestMm = 1;        ///< smallest distance of the sharp plane from the eye
constexpr double kLensPerFocus = 0.04;  ///< diameter of the lens that a pinhole gets, relative to the focus distance
constexpr double kWidestLensMm = 200;

/// Moves the eye along the view until it is `distanceMm` from the sharp plane, which stays where it is.
Camera steppedBack(Camera camera, double distanceMm) {
    const dvec3 forward = camera.forward();
    const dvec3 inFocus = camera.eyeMm + forward * camera.focusDistanceMm();
    camera.eyeMm = inFocus - forward * distanceMm;
    if (camera.focusMm > 0)
        camera.focusMm = distanceMm;
    if (glm::dot(camera.targetMm - camera.eyeMm, forward) < kNearestMm)  // the eye would have passed the target
        camera.targetMm = inFocus;
    return camera;
}

}  // namespace

Camera withType(const Camera& camera, Camera::Type type) {
    if (type == camera.type)
        return camera;
    Camera other = camera;
    if (type == Camera::Type::orthographic)
        other.heightMm = camera.heightInFocusMm();
    else
        other = steppedBack(camera, std::max(camera.heightMm / heightPerDepth(camera.fovDegrees), kNearestMm));
    other.type = type;
    return other;
}

Camera withFieldOfView(const Camera& camera, double degrees) {
    Camera other = camera;
    if (camera.type == Camera::Type::perspective)
        other = steppedBack(camera, std::max(camera.heightInFocusMm() / heightPerDepth(degrees), kNearestMm));
    other.fovDegrees = degrees;
    return other;
}

Camera focusedAt(const Camera& camera, double depthMm) {
    Camera other = camera;
    other.focusMm = std::max(depthMm, kNearestMm);
    if (camera.apertureMm == 0)
        other.apertureMm = std::min(std::round(kLensPerFocus * other.focusMm), kWidestLensMm);
    return other;
}

/// In the sharp plane, a point at the depth d is blurred over aperture |d - focus| / d. In a parallel view, rays that
/// are parallel in the middle of the lens spread alike, so the point is blurred over aperture |d - focus| / focus.
SharpDepths sharpDepths(const Camera& camera) {
    constexpr double kParts = 500, kInfinite = std::numeric_limits<double>::infinity();
    if (camera.apertureMm == 0)
        return {0, kInfinite};
    const double focus = camera.focusDistanceMm(), blur = camera.heightInFocusMm() / kParts / camera.apertureMm;
    if (camera.type == Camera::Type::orthographic)
        return {std::max(focus * (1 - blur), 0.0), focus * (1 + blur)};
    return {focus / (1 + blur), blur < 1 ? focus / (1 - blur) : kInfinite};
}

}  // namespace pdr
