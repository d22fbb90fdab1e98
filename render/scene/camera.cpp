#include "render/scene/camera.h"

#include <algorithm>
#include <cmath>

#include "render/scene/field_check.h"
#include "render/scene/fields/camera_fields.h"
#include "render/scene/perspective.h"

namespace pdr {

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

double Camera::heightInFocusMm() const {
    return type == Type::perspective ? heightPerDepth(fovDegrees) * focusDistanceMm() : heightMm;
}

Result<void> Camera::check() const {
    if (auto ok = FieldCheck::check(*this, "camera"); !ok)
        return ok;
    if (glm::length(targetMm - eyeMm) < kLeastMm)
        return Error{phrase("must differ from eyeMm"), "camera.targetMm", ""};
    if (!(glm::length(glm::cross(forward(), up)) > 1e-9 * glm::length(up)))
        return Error{phrase("must not lie along the view"), "camera.up", ""};
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
