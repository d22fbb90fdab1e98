#include "ui/view/drag_tool.h"

#include <QLineF>
#include <utility>

namespace pdr::ui {

void DragTool::press(const ViewPointer& pointer) {
    dragging_ = false;
    pressed_ = last_ = pointer.at;
}

void DragTool::move(const ViewPointer& pointer) {
    dragging_ = dragging_ || QLineF(pressed_, pointer.at).length() > tremble_;
    if (dragging_)
        report(pointer, true);
}

void DragTool::release(const ViewPointer& pointer) {
    if (std::exchange(dragging_, false))
        report(pointer, false);
    else if (pointer.image.camera)
        emit clicked(pointer.fractions());
}

void DragTool::report(const ViewPointer& pointer, bool moving) {
    const dvec2 total = pointer.image.inHeights(pointer.at - pressed_);
    const dvec2 step = pointer.image.inHeights(pointer.at - std::exchange(last_, pointer.at));
    emit dragged({total.x, total.y}, {step.x, step.y}, moving);
}

}  // namespace pdr::ui
