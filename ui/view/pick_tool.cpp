#include "ui/view/pick_tool.h"

namespace pdr::ui {

void PickTool::setActive(bool active) {
    if (active == active_)
        return;
    active_ = active;
    if (active)
        emit activated();
    emit changed();
    emit activeChanged(active);
}

bool PickTool::cancel() {
    const bool active = active_;
    setActive(false);
    return active;
}

/// Picks where the button is released, so that the place can be corrected until then.
void PickTool::release(const ViewPointer& pointer) {
    if (!active_ || !pointer.image.camera)
        return;
    setActive(false);
    emit picked(pointer.fractions());
}

std::optional<Qt::CursorShape> PickTool::cursor() const {
    return active_ ? std::optional(Qt::CrossCursor) : std::nullopt;
}

}  // namespace pdr::ui
