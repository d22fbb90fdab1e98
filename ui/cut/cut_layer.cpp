#include "ui/cut/cut_layer.h"

#include <algorithm>
#include <utility>

#include "ui/text/cut_text.h"

namespace pdr::ui {
namespace {

dvec2 fractionsOf(const ViewPointer& pointer) {
    const QPointF place = pointer.fractions();
    return {place.x(), place.y()};
}

ViewGeometry geometryOf(const ImagePlace& image) {
    return {*image.camera, image.area.width() / image.area.height()};
}

/// Paints the text beside the place, inside the view.
void paintText(QPainter& painter, QSize view, QPointF place, const QString& text) {
    constexpr int kAway = 14, kPadding = 5;
    QRect box = painter.fontMetrics().boundingRect(text).adjusted(-kPadding, -kPadding, kPadding, kPadding);
    box.moveTo(place.toPoint() + QPoint(kAway, kAway));
    box.moveRight(std::min(box.right(), view.width() - 1));
    box.moveBottom(std::min(box.bottom(), view.height() - 1));
    box.moveLeft(std::max(box.left(), 0));
    box.moveTop(std::max(box.top(), 0));
    painter.fillRect(box, QColor(12, 13, 15, 210));
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

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

void CutLayer::setImage(const ImagePlace& image) {
    image_ = image;
    mark();
}

void CutLayer::setHandlesShown(bool shown) {
    shown_ = shown;
    grip_.reset();
    light(std::nullopt);
    mark();
}

bool CutLayer::cancel() {
    if (!grip_)
        return false;
    clip_ = grip_->before;
    grip_.reset();
    light(std::nullopt);
    mark();
    if (std::exchange(moved_, false))
        emit gestureGivenUp();
    return true;
}

bool CutLayer::takes(const ViewPointer& pointer) const {
    if (pointer.button != Qt::LeftButton || !marks_.at(pointer.at))
        return false;
    return pointer.twice || pointer.modifiers == Qt::NoModifier;
}

void CutLayer::press(const ViewPointer& pointer) {
    const CutHandle handle = *marks_.at(pointer.at);
    if (pointer.twice)
        return bringBack(handle);
    grip_ = CutGrip{clip_, *uncut_, handle, geometryOf(pointer.image), fractionsOf(pointer)};
    moved_ = false;
    light(handle);
}

void CutLayer::move(const ViewPointer& pointer) {
    if (grip_)
        edit(dragged(*grip_, fractionsOf(pointer)), true);
}

void CutLayer::release(const ViewPointer&) {
    if (std::exchange(grip_, std::nullopt) && std::exchange(moved_, false))
        edit(Clip(clip_), false);
}

bool CutLayer::hover(const ViewPointer& pointer) {
    light(marks_.at(pointer.at));
    return lit_.has_value();
}

void CutLayer::bringBack(CutHandle handle) {
    light(std::nullopt);
    if (const Clip clip = withoutCut(clip_, *uncut_, handle); clip != clip_)
        edit(clip, false);
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
    lit_ = handle;
    emit changed();
}

std::optional<Qt::CursorShape> CutLayer::cursor() const {
    return lit_ ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

void CutLayer::mark() {
    marks_ = {};
    if (shown_ && uncut_ && image_.camera && !image_.view.isEmpty())
        marks_ = {clip_, *uncut_, geometryOf(image_), image_.area};
    emit changed();
}

void CutLayer::paint(QPainter& painter, const ImagePlace& image) const {
    marks_.paint(painter, lit_);
    if (lit_ && uncut_)
        if (const auto place = marks_.placeOf(*lit_))
            paintText(painter, image.view, *place, handleText(clip_, *uncut_, *lit_));
}

}  // namespace pdr::ui
