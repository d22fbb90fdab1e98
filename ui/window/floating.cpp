#include "ui/window/floating.h"

#include <QEvent>

namespace pdr::ui {

Floating::Floating(QWidget* image) : QFrame(image) {
    setAttribute(Qt::WA_NoMousePropagation);
    setAutoFillBackground(true);
    if (image)
        image->installEventFilter(this);
}

void Floating::place() {
    if (parentWidget() && !isHidden())
        setGeometry(placeIn(parentWidget()->size()));
}

bool Floating::event(QEvent* event) {
    const bool taken = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::ShowToParent)
        place();
    return taken;
}

bool Floating::eventFilter(QObject* image, QEvent* event) {
    if (event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(image, event);
}

}  // namespace pdr::ui
