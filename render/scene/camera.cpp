#include "render/scene/camera.h"

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

bool finite(dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

dvec3 Camera::forward() const {
    return glm::normalize(targetMm - eyeMm);
}

dvec3 Camera::right() const {
    return glm::normalize(glm::cross(forward(), up));
}

dvec3 Camera::imageUp() const {
    return glm::cross(right(), forward());
}

double Camera::focusDistanceMm() const {
    return focusMm > 0 ? focusMm : glm::length(targetMm - eyeMm);
}

Result<void> Camera::check() const {
    if (!finite(eyeMm))
        return Error{"eyeMm must be three finite numbers", "camera.eyeMm", ""};
    if (!finite(targetMm) || targetMm == eyeMm)
        return Error{"targetMm must be finite and differ from eyeMm", "camera.targetMm", ""};
    if (!finite(up) || glm::length(glm::cross(glm::normalize(targetMm - eyeMm), up)) <= 1e-9 * glm::length(up))
        return Error{"up must not be zero nor lie along the view", "camera.up", ""};
    if (type == Type::perspective && !(fovDegrees > 0 && fovDegrees < 180))
        return Error{"fovDegrees must lie in (0, 180)", "camera.fovDegrees", ""};
    if (type == Type::orthographic && !(heightMm > 0 && heightMm <= 1e9))
        return Error{"heightMm must lie in (0, 1e9]", "camera.heightMm", ""};
    if (!(apertureMm >= 0 && apertureMm <= 200))
        return Error{"apertureMm must lie in [0, 200]", "camera.apertureMm", ""};
    if (!(focusMm >= 0 && focusMm <= 1e9))
        return Error{"focusMm must lie in [0, 1e9]", "camera.focusMm", ""};
    return {};
}

Camera standardView(StandardView view, dvec3 centreMm, double radiusMm, double aspect) {
    struct Side {
        dvec3 towardsEye, up;
    };
    // LPS: +x is the patient's left, +y posterior, +z the head.
    static constexpr Side sides[] = {
        {{0, -1, 0}, {0, 0, 1}},   // anterior
        {{0, 1, 0}, {0, 0, 1}},    // posterior
        {{1, 0, 0}, {0, 0, 1}},    // left
        {{-1, 0, 0}, {0, 0, 1}},   // right
        {{0, 0, 1}, {0, -1, 0}},   // superior, the face up
        {{0, 0, -1}, {0, -1, 0}},  // inferior, as an axial slice is shown
    };
    const Side& side = sides[int(view)];
    Camera camera;
    const double halfAngle = glm::radians(camera.fovDegrees) / 2;
    const double narrower = std::atan(std::tan(halfAngle) * std::min(aspect, 1.0));
    camera.targetMm = centreMm;
    camera.eyeMm = centreMm + side.towardsEye * (radiusMm / std::sin(narrower));
    camera.up = side.up;
    camera.heightMm = 2 * radiusMm / std::min(aspect, 1.0);
    return camera;
}

}  // namespace pdr
