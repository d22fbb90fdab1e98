#include "ui/measure/marks_layer.h"

#include <QLineF>
#include <cmath>
#include <utility>

#include "ui/view/view_places.h"

namespace pdr::ui {
namespace {

constexpr double kNearPx = 9;  ///< how near the pointer takes hold of a handle [px]

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

void MarksLayer::setDrawn(MarkShape shape, std::vector<dvec3> placesMm) {
    drawn_ = {.shape = shape, .placesMm = std::move(placesMm)};
    emit changed();
}

void MarksLayer::setClosing(bool closable, bool byEnter) {
    closable_ = closable;
    closableByEnter_ = byEnter;
}

void MarksLayer::setHidden(std::map<std::uint64_t, MarkHidden> hidden) {
    if (hidden == hidden_)
        return;
    hidden_ = std::move(hidden);
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
            if (!at || std::abs(depthMm(pointer.image, mark.placesMm[i])) > kInSliceMm)
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

/// Returns whether a press closes what is being drawn. The first press of a double click has set its last place.
bool MarksLayer::closes(const ViewPointer& pointer) const {
    if (!closable_ || drawn_.placesMm.empty())
        return false;
    const auto first = seenAt(pointer.image, drawn_.placesMm.front());
    return pointer.twice || (first && QLineF(*first, pointer.at).length() <= kNearPx);
}

void MarksLayer::press(const ViewPointer& pointer) {
    if (drawing_ && closes(pointer))
        return emit closed();
    if (drawing_ && pointer.twice && drawn_.shape == MarkShape::polygon)
        return;  // too few corners to close: the place is there already
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
    if (drawing_ && slice_ && pointer.image.camera) {
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

bool MarksLayer::key(const QKeyEvent& event) {
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (!slice_ || !drawing_)
        return false;
    if (event.key() == Qt::Key_Backspace)
        emit takenBack();
    else if (enter && closableByEnter_)
        emit closed();
    else
        return false;
    return true;
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
    MarkPainter marks(painter, image, slice_);
    for (const ShownMark& mark : marks_) {
        const auto hidden = hidden_.find(mark.id);
        marks.paint(mark, lit_ && lit_->id == mark.id ? lit_->index : -1,
                    hidden == hidden_.end() ? MarkHidden() : hidden->second);
    }
    marks.paintLabels();
    if (drawing_)
        paintDrawn(painter, image);
}

/// Paints what is being drawn; the pointer is its next place.
void MarksLayer::paintDrawn(QPainter& painter, const ImagePlace& image) const {
    ShownMark open = drawn_;
    if (open.placesMm.empty())
        return;
    if (pointer_)
        open.placesMm.push_back(*pointer_);
    MarkPainter(painter, image, slice_).paint(open);
}

}  // namespace pdr::ui
