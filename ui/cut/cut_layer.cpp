#include "ui/cut/cut_layer.h"

#include <QEvent>
#include <QMouseEvent>
#include <utility>

#include "ui/text/cut_text.h"
#include "ui/view/shown_picture.h"

namespace pdr::ui {

void CutLayer::setCuts(const Clip& clip, const std::optional<Uncut>& uncut) {
    if (clip != clip_ || uncut != uncut_) {
        grip_.reset();
        moved_ = false;
        light(std::nullopt);
    }
    clip_ = clip;
    uncut_ = uncut;
    mark();
}

void CutLayer::setPicture(const Camera& camera, QSize size) {
    camera_ = camera;
    size_ = size;
    mark();
}

void CutLayer::setHandlesShown(bool shown) {
    shown_ = shown;
    grip_.reset();
    light(std::nullopt);
    mark();
}

bool CutLayer::giveUp() {
    if (!grip_)
        return false;
    clip_ = grip_->before;
    grip_.reset();
    mark();
    if (std::exchange(moved_, false))
        emit gestureGivenUp();
    return true;
}

bool CutLayer::eventFilter(QObject* picture, QEvent* event) {
    const bool taken = PictureLayer::eventFilter(picture, event);
    switch (event->type()) {
        case QEvent::Resize:
            mark();
            break;
        case QEvent::MouseButtonPress:
            return press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove:
            return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease:
            return release(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonDblClick:
            return bringBack(*static_cast<QMouseEvent*>(event));
        case QEvent::Leave:
            light(std::nullopt);
            break;
        default:
            break;
    }
    return taken;
}

bool CutLayer::press(const QMouseEvent& event) {
    if (grip_)
        return true;
    const auto handle = marks_.at(event.position());
    if (!handle || event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier)
        return false;
    const QRectF shown = area();
    const ViewGeometry view(*camera_, shown.width() / shown.height());
    grip_ = CutGrip{clip_, *uncut_, *handle, view, placeOf(event.position())};
    moved_ = false;
    light(handle);
    return true;
}

bool CutLayer::move(const QMouseEvent& event) {
    if (!grip_) {
        light(event.buttons() == Qt::NoButton ? marks_.at(event.position()) : std::nullopt);
        return false;
    }
    edit(dragged(*grip_, placeOf(event.position())), true);
    return true;
}

bool CutLayer::release(const QMouseEvent& event) {
    if (!grip_)
        return false;
    if (event.button() != Qt::LeftButton)
        return true;
    grip_.reset();
    if (std::exchange(moved_, false))
        edit(Clip(clip_), false);
    return true;
}

bool CutLayer::bringBack(const QMouseEvent& event) {
    const auto handle = marks_.at(event.position());
    if (!handle || event.button() != Qt::LeftButton)
        return false;
    light(std::nullopt);
    if (const Clip clip = withoutCut(clip_, *uncut_, *handle); clip != clip_)
        edit(clip, false);
    return true;
}

void CutLayer::edit(const Clip& clip, bool moving) {
    moved_ = moving;
    clip_ = clip;
    mark();
    emit clipEdited(clip, moving);
}

void CutLayer::light(const std::optional<CutHandle>& handle) {
    if (handle == lit_)
        return;
    if (lit_.has_value() != handle.has_value())
        parentWidget()->setCursor(handle ? Qt::SizeAllCursor : Qt::ArrowCursor);
    lit_ = handle;
    update();
}

void CutLayer::mark() {
    marks_ = {};
    if (shown_ && uncut_ && camera_ && !size_.isEmpty() && !size().isEmpty())
        marks_ = {clip_, *uncut_, {*camera_, area().width() / area().height()}, area()};
    update();
}

QRectF CutLayer::area() const {
    return pictureArea(size_, {size(), devicePixelRatioF()});
}

/// Returns a place in fractions of the image's width and height.
dvec2 CutLayer::placeOf(QPointF point) const {
    const QRectF shown = area();
    return {(point.x() - shown.x()) / shown.width(), (point.y() - shown.y()) / shown.height()};
}

void CutLayer::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    marks_.paint(painter, lit_);
    if (lit_ && uncut_)
        if (const auto place = marks_.placeOf(*lit_))
            paintText(painter, *place, handleText(clip_, *uncut_, *lit_));
}

/// Paints the text beside the place, inside the layer.
void CutLayer::paintText(QPainter& painter, QPointF place, const QString& text) const {
    constexpr int kAway = 14, kPadding = 5;
    QRect box = painter.fontMetrics().boundingRect(text).adjusted(-kPadding, -kPadding, kPadding, kPadding);
    box.moveTo(place.toPoint() + QPoint(kAway, kAway));
    box.moveRight(std::min(box.right(), width() - 1));
    box.moveBottom(std::min(box.bottom(), height() - 1));
    box.moveLeft(std::max(box.left(), 0));
    box.moveTop(std::max(box.top(), 0));
    painter.fillRect(box, QColor(12, 13, 15, 210));
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace pdr::ui
