#include "ui/view/camera_drag.h"

#include <QLineF>
#include <cmath>

#include "render/scene/orbit.h"

namespace pdr::ui {

Camera zoomedByDrag(const Camera& camera, dvec2 drag) {
    constexpr double kPerHeight = 8;  // magnification of a drag over the whole height
    return zoomed(camera, std::pow(kPerHeight, -drag.y));
}

void CameraDrag::press(const ViewPointer& pointer) {
    dragging_ = false;
    pressed_ = last_ = pointer.at;
}

/// Leaves the camera alone until the pointer has moved further than a hand trembles: a click must not begin the image
/// anew.
void CameraDrag::move(const ViewPointer& pointer) {
    dragging_ = dragging_ || QLineF(pressed_, pointer.at).length() > kTremble;
    if (!dragging_)
        return;
    const dvec2 drag = pointer.image.inHeights(pointer.at - last_);
    last_ = pointer.at;
    if (camera_.get())
        camera_.edit(edit_(*camera_.get(), drag));
}

void CameraDrag::release(const ViewPointer& pointer) {
    if (!dragging_)
        emit clicked(pointer.at);
}

}  // namespace pdr::ui
