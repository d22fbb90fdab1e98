#include "ui/region_box.h"

#include <QMouseEvent>
#include <QPainter>

namespace pdr::ui {
namespace {

constexpr double kLeastSide = 6;  ///< of a box [px]: less is a click

}  // namespace

void RegionBox::setBox(const std::optional<QRectF>& box) {
    box_ = box;
    update();
}

void RegionBox::stopDrawing() {
    from_.reset();
    leaveMouse();
}

void RegionBox::mousePressEvent(QMouseEvent* event) {
    from_ = to_ = event->position();
}

void RegionBox::mouseMoveEvent(QMouseEvent* event) {
    to_ = event->position();
    update();
}

void RegionBox::mouseReleaseEvent(QMouseEvent* event) {
    if (!from_)
        return;
    to_ = event->position();
    const QRectF box = dragged();
    stopDrawing();
    if (box.width() < kLeastSide || box.height() < kLeastSide)
        emit notDrawn();
    else
        emit drawn({box.x() / width(), box.y() / height(), box.width() / width(), box.height() / height()});
}

/// [px]
QRectF RegionBox::dragged() const {
    return QRectF(*from_, to_).normalized() & QRectF(rect());
}

QRectF RegionBox::inPixels(const QRectF& box) const {
    return {box.x() * width(), box.y() * height(), box.width() * width(), box.height() * height()};
}

void RegionBox::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (from_)
        drawMark(painter, dragged(), 1);
    else if (box_)
        drawMark(painter, inPixels(*box_), 1);
}

}  // namespace pdr::ui
