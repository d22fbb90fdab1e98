#include "ui/annotation/slice_camera.h"

namespace pdr::ui {

Camera cameraFacing(const SlicePlane& plane) {
    constexpr double kDistanceMm = 1000;  // of no effect: the view is parallel
    Camera camera;
    camera.type = Camera::Type::orthographic;
    camera.targetMm = plane.middleMm();
    camera.eyeMm = camera.targetMm - kDistanceMm * plane.normal();
    camera.up = -plane.down;
    camera.heightMm = plane.mmPerPixel * plane.size.y;
    return camera;
}

}  // namespace pdr::ui
