#include "ui/window/floating.h"

#include <QEvent>

namespace pdr::ui {

Floating::Floating(QWidget* picture) : QFrame(picture) {
    setAttribute(Qt::WA_NoMousePropagation);
    setAutoFillBackground(true);
    if (picture)
        picture->installEventFilter(this);
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

bool Floating::eventFilter(QObject* picture, QEvent* event) {
    if (event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(picture, event);
}

}  // namespace pdr::ui
