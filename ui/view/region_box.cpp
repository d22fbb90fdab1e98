#include "ui/view/region_box.h"

#include <QMouseEvent>
#include <QPainter>

#include "ui/view/shown_picture.h"

namespace pdr::ui {
namespace {

constexpr double kLeastSide = 6;  ///< least side of a box [px]; a smaller one counts as a click

}  // namespace

void RegionBox::setBox(const std::optional<QRectF>& box) {
    box_ = box;
    update();
}

void RegionBox::setPicture(QSize size) {
    size_ = size;
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
        emit drawn(inParts(box));
}

/// Returns the box that the drag has drawn so far, clipped to the image [px].
QRectF RegionBox::dragged() const {
    return QRectF(*from_, to_).normalized() & QRectF(rect()) & area();
}

/// Returns the part of the view that the image takes [px].
QRectF RegionBox::area() const {
    return size_.isEmpty() ? QRectF(rect()) : pictureArea(size_, {size(), devicePixelRatioF()});
}

QRectF RegionBox::inParts(const QRectF& box) const {
    const QRectF whole = area();
    return {(box.x() - whole.x()) / whole.width(), (box.y() - whole.y()) / whole.height(), box.width() / whole.width(),
            box.height() / whole.height()};
}

QRectF RegionBox::inPixels(const QRectF& box) const {
    const QRectF whole = area();
    return {whole.x() + box.x() * whole.width(), whole.y() + box.y() * whole.height(), box.width() * whole.width(),
            box.height() * whole.height()};
}

void RegionBox::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (from_)
        drawMark(painter, dragged(), 1);
    else if (box_)
        drawMark(painter, inPixels(*box_), 1);
}

}  // namespace pdr::ui
