#include "ui/measure/marks_layer.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/text/language.h"
#include "ui/view/mark.h"
#include "ui/view/view_places.h"

namespace pdr::ui {
namespace {

constexpr double kHandle = 5;     ///< radius of a handle [px]
constexpr double kNearPx = 9;     ///< how near the pointer takes hold of a handle [px]
constexpr double kFarMm = 20;     ///< measurements farther off a slice are not shown
constexpr double kInSlice = 0.6;  ///< how far off a slice a place still counts as lying in it [mm]

void drawText(QPainter& painter, QPointF place, const QString& text) {
    painter.setPen(Qt::black);
    for (const QPointF off : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)})
        painter.drawText(place + off, text);
    painter.setPen(QColor(kMarkColour));
    painter.drawText(place, text);
}

}  // namespace

void MarksLayer::setMarks(std::vector<ShownMark> marks) {
    if (marks == marks_)
        return;
    marks_ = std::move(marks);
    lit_.reset();
    emit changed();
}

void MarksLayer::setDrawing(bool drawing) {
    drawing_ = drawing;
    pointer_.reset();
    emit changed();
}

void MarksLayer::setDrawn(std::vector<dvec3> placesMm) {
    drawn_ = std::move(placesMm);
    emit changed();
}

/// Returns the handle within reach of the pointer, in a slice only if it lies in the slice.
std::optional<MarksLayer::Handle> MarksLayer::handleAt(const ViewPointer& pointer) const {
    if (!slice_ || !pointer.image.camera)
        return std::nullopt;
    std::optional<Handle> nearest;
    double reach = kNearPx;
    for (const ShownMark& mark : marks_)
        for (std::size_t i = 0; i < mark.placesMm.size(); ++i) {
            const auto at = seenAt(pointer.image, mark.placesMm[i]);
            if (!at || std::abs(depthMm(pointer.image, mark.placesMm[i])) > kInSlice)
                continue;
            if (const double distance = QLineF(*at, pointer.at).length(); distance <= reach) {
                reach = distance;
                nearest = Handle{mark.id, int(i)};
            }
        }
    return nearest;
}

bool MarksLayer::takes(const ViewPointer& pointer) const {
    const bool plain = !(pointer.modifiers & ~Qt::AltModifier);
    return slice_ && pointer.image.camera && pointer.button == Qt::LeftButton && plain &&
           (drawing_ || handleAt(pointer));
}

void MarksLayer::press(const ViewPointer& pointer) {
    if (drawing_)
        return emit placed(placeUnder(pointer.image, pointer.at), pointer.modifiers.testFlag(Qt::AltModifier));
    dragged_ = handleAt(pointer);
    pressed_ = pointer.at;
    dragging_ = false;
    if (dragged_)
        emit selected(dragged_->id);
}

void MarksLayer::move(const ViewPointer& pointer) {
    if (drawing_) {
        pointer_ = placeUnder(pointer.image, pointer.at);
        return emit changed();
    }
    dragging_ = dragging_ || QLineF(pressed_, pointer.at).length() > kTremble;
    if (dragging_)
        reportDrag(pointer, true);
}

/// Ends a drag. A click on a handle has selected its measurement, and moves nothing.
void MarksLayer::release(const ViewPointer& pointer) {
    if (std::exchange(dragging_, false))
        reportDrag(pointer, false);
    dragged_.reset();
}

void MarksLayer::reportDrag(const ViewPointer& pointer, bool moving) {
    if (dragged_)
        emit dragged(dragged_->id, dragged_->index, placeUnder(pointer.image, pointer.at),
                     pointer.modifiers.testFlag(Qt::AltModifier), moving);
}

bool MarksLayer::hover(const ViewPointer& pointer) {
    if (drawing_ && pointer.image.camera) {
        pointer_ = placeUnder(pointer.image, pointer.at);
        emit changed();
        return true;
    }
    light(handleAt(pointer));
    return lit_.has_value();
}

void MarksLayer::leave() {
    pointer_.reset();
    light(std::nullopt);
}

void MarksLayer::light(const std::optional<Handle>& handle) {
    if (std::exchange(lit_, handle) != handle)
        emit changed();
}

bool MarksLayer::cancel() {
    if (!drawing_)
        return false;
    emit drawingCancelled();
    return true;
}

std::optional<Qt::CursorShape> MarksLayer::cursor() const {
    if (drawing_)
        return Qt::CrossCursor;
    return lit_ || dragged_ ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

void MarksLayer::paint(QPainter& painter, const ImagePlace& image) const {
    if (!image.camera)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ShownMark& mark : marks_)
        paintMark(painter, image, mark);
    if (!drawing_ || drawn_.empty())
        return;
    ShownMark open{.placesMm = drawn_};
    if (pointer_)
        open.placesMm.push_back(*pointer_);
    paintMark(painter, image, open);
}

void MarksLayer::paintMark(QPainter& painter, const ImagePlace& image, const ShownMark& mark) const {
    std::vector<QPointF> points;
    double nearest = INFINITY;  // signed distance of the end that lies nearest to the slice
    bool inSlice = true;
    for (const dvec3& place : mark.placesMm) {
        const auto at = seenAt(image, place);
        if (!at)
            return;
        points.push_back(*at);
        const double depth = depthMm(image, place);
        inSlice = inSlice && std::abs(depth) <= kInSlice;
        if (std::abs(depth) < std::abs(nearest))
            nearest = depth;
    }
    if (slice_ && std::abs(nearest) > kFarMm)
        return;
    const bool solid = !slice_ || inSlice;
    const QPen pen(QColor(kMarkColour), mark.selected ? 2 : 1.3, solid ? Qt::SolidLine : Qt::DashLine);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        drawMarkLine(painter, points[i], points[i + 1], pen);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool lit = lit_ == Handle{mark.id, int(i)};
        painter.setPen(QPen(Qt::black, 1));
        painter.setBrush(QColor(kMarkColour));
        painter.drawEllipse(points[i], lit ? kHandle : kHandle / 2, lit ? kHandle : kHandle / 2);
    }
    QString text = mark.text;
    if (!solid && std::abs(nearest) > kInSlice)
        text += "  " + tr("%1 mm off").arg(number(std::abs(nearest), 1));
    if (!text.isEmpty())
        drawText(painter, points.back() + QPointF(8, -8), text);
}

}  // namespace pdr::ui
