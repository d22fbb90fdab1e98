#include "ui/view/picture_layer.h"

#include <QEvent>

namespace pdr::ui {

PictureLayer::PictureLayer(QWidget* picture) : QWidget(picture) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    resize(picture->size());
    picture->installEventFilter(this);
}

void PictureLayer::takeMouse() {
    setAttribute(Qt::WA_TransparentForMouseEvents, false);
    setCursor(Qt::CrossCursor);
    raise();
}

void PictureLayer::leaveMouse() {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    unsetCursor();
    update();
}

void PictureLayer::drawMark(QPainter& painter, const QPolygonF& line, double width) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 170), 3));
    painter.drawPolygon(line);
    painter.setPen(QPen(QColor(kMarkColour), width));
    painter.drawPolygon(line);
}

bool PictureLayer::eventFilter(QObject* picture, QEvent* event) {
    if (event->type() == QEvent::Resize)
        resize(parentWidget()->size());
    return QWidget::eventFilter(picture, event);
}

}  // namespace pdr::ui
