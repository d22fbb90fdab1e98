#include "ui/view/view_pointer.h"

namespace pdr::ui {

ViewPointer pointerOf(const QSinglePointEvent& event, const ImagePlace& image) {
    return {event.position(),
            event.button(),
            event.buttons(),
            event.modifiers(),
            event.type() == QEvent::MouseButtonDblClick,
            image};
}

double clicksOf(const QWheelEvent& event) {
    constexpr double kPerClick = 120;
    return event.angleDelta().y() / kPerClick;
}

}  // namespace pdr::ui
