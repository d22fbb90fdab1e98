#include "ui/region_box.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

namespace pdr::ui {
namespace {

constexpr double kLeastSide = 6;  ///< of a box [px]: less is a click
constexpr QRgb kLine = qRgb(255, 205, 110);

/// On dark ground and on bright bone.
void paintBox(QPainter& painter, const QRectF& box) {
    painter.setPen(QPen(QColor(0, 0, 0, 170), 3));
    painter.drawRect(box);
    painter.setPen(QPen(QColor(kLine), 1));
    painter.drawRect(box);
}

}  // namespace

RegionBox::RegionBox(QWidget* picture) : QWidget(picture) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    resize(picture->size());
    picture->installEventFilter(this);
}

void RegionBox::setBox(const std::optional<QRectF>& box) {
    box_ = box;
    update();
}

void RegionBox::startDrawing() {
    drawing_ = true;
    setAttribute(Qt::WA_TransparentForMouseEvents, false);
    setCursor(Qt::CrossCursor);
    raise();
}

void RegionBox::stopDrawing() {
    drawing_ = false;
    from_.reset();
    setAttribute(Qt::WA_TransparentForMouseEvents);
    unsetCursor();
    update();
}

bool RegionBox::eventFilter(QObject* picture, QEvent* event) {
    if (event->type() == QEvent::Resize)
        resize(parentWidget()->size());
    return QWidget::eventFilter(picture, event);
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
        paintBox(painter, dragged());
    else if (box_)
        paintBox(painter, inPixels(*box_));
}

}  // namespace pdr::ui
