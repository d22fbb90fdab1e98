#include "ui/view/camera_steps.h"

#include <cmath>

#include "render/scene/orbit.h"

namespace pdr::ui {
namespace {

constexpr double kKeyStep = 1.0 / 24;  // of the view's height: 7.5 degrees
constexpr double kZoomPerClick = 1.15;

/// Returns the camera after a key; none if the key edits nothing.
std::optional<Camera> afterKey(const Camera& camera, const QKeyEvent& event) {
    const auto turnedOrMoved = [&](dvec2 drag) {
        return event.modifiers().testFlag(Qt::ShiftModifier) ? panned(camera, drag) : orbited(camera, drag);
    };
    switch (event.key()) {
        case Qt::Key_Left:
            return turnedOrMoved({-kKeyStep, 0});
        case Qt::Key_Right:
            return turnedOrMoved({kKeyStep, 0});
        case Qt::Key_Up:
            return turnedOrMoved({0, -kKeyStep});
        case Qt::Key_Down:
            return turnedOrMoved({0, kKeyStep});
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoomed(camera, kZoomPerClick);
        case Qt::Key_Minus:
            return zoomed(camera, 1 / kZoomPerClick);
        default:
            return std::nullopt;
    }
}

}  // namespace

/// Zooms so that the point under the pointer stays under it.
bool CameraSteps::wheel(const ViewPointer& pointer, double clicks) {
    if (!camera_.get())
        return false;
    const double factor = std::pow(kZoomPerClick, clicks);
    const dvec2 cursor = pointer.image.inHeights(pointer.at - QRectF({}, QSizeF(pointer.image.view)).center());
    camera_.step(panned(zoomed(*camera_.get(), factor), cursor * (1 - factor)));
    return true;
}

bool CameraSteps::key(const QKeyEvent& event) {
    if (!camera_.get())
        return false;
    const auto edited = afterKey(*camera_.get(), event);
    if (edited)
        camera_.step(*edited);
    return edited.has_value();
}

}  // namespace pdr::ui
