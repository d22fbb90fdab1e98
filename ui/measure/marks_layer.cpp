#include "ui/measure/marks_layer.h"

#include <QLineF>
#include <cmath>
#include <utility>

#include "ui/view/view_places.h"

namespace pdr::ui {
void MarksLayer::setMarks(std::vector<ShownMark> marks) {
    if (marks == marks_ && !loose_)
        return;
    marks_ = std::move(marks);
    lit_.reset();
    loose_.reset();
    emit changed();
}

void MarksLayer::putBack() {
    loose_.reset();
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

void MarksLayer::setElsewhere(bool elsewhere) {
    elsewhere_ = elsewhere;
    if (elsewhere)
        pointer_.reset();
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

/// Returns the handle within reach of the pointer. Whoever drags a place sees it: what lies off a slice, or is hidden
/// in the image, has none. In the image there is none while something is drawn, since clicks set its places.
std::optional<MarkHandle> MarksLayer::handleAt(const ViewPointer& pointer) const {
    if (!pointer.image.camera || (drawing_ && !slice_))
        return std::nullopt;
    return ui::handleAt(marks_, pointer, [&](const ShownMark& mark, std::size_t index) {
        if (slice_)
            return std::abs(depthMm(pointer.image, mark.placesMm[index])) <= kInSliceMm;
        const auto hidden = hidden_.find(mark.id);
        const bool known = hidden != hidden_.end() && index < hidden->second.places.size();
        return !isFlat(mark.shape) && !(known && hidden->second.places[index]);
    });
}

bool MarksLayer::takes(const ViewPointer& pointer) const {
    const bool plain = !(pointer.modifiers & ~Qt::AltModifier);
    return pointer.image.camera && pointer.button == Qt::LeftButton && plain &&
           ((drawing_ && slice_) || handleAt(pointer));
}

/// Returns whether a press closes what is being drawn. The first press of a double click has set its last place.
bool MarksLayer::closes(const ViewPointer& pointer) const {
    if (!closable_ || drawn_.placesMm.empty())
        return false;
    const auto first = seenAt(pointer.image, drawn_.placesMm.front());
    return pointer.twice || (first && QLineF(*first, pointer.at).length() <= kHandleReach);
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
    loose_.reset();
    if (dragged_)
        emit selected(dragged_->id);
}

void MarksLayer::move(const ViewPointer& pointer) {
    if (drawing_)
        return showNext(pointer);
    dragging_ = dragging_ || QLineF(pressed_, pointer.at).length() > kTremble;
    if (dragging_)
        drag(pointer, true);
}

/// Ends a drag. A click on a handle has selected its measurement, and moves nothing.
void MarksLayer::release(const ViewPointer& pointer) {
    if (std::exchange(dragging_, false))
        drag(pointer, false);
    dragged_.reset();
}

/// Moves the place that was pressed. In the image it follows the pointer beside its surface, at the depth that it had:
/// which place the image shows is asked once it is dropped, since the answer may be a choice, or none.
void MarksLayer::drag(const ViewPointer& pointer, bool moving) {
    if (!dragged_ || !pointer.image.camera)
        return;
    const auto [id, index] = *dragged_;
    if (slice_)
        return emit dragged(id, index, placeUnder(pointer.image, pointer.at),
                            pointer.modifiers.testFlag(Qt::AltModifier), moving);
    loose_ = dragged_;
    looseAt_ = pointer.at;
    emit changed();
    if (!moving)
        emit dropped(id, index, pointer.fractions());
}

/// Shows the pointer as the next place of what is being drawn.
void MarksLayer::showNext(const ViewPointer& pointer) {
    if (elsewhere_)
        return;
    pointer_ = placeUnder(pointer.image, pointer.at);
    emit changed();
}

bool MarksLayer::hover(const ViewPointer& pointer) {
    if (drawing_ && slice_ && pointer.image.camera) {
        showNext(pointer);
        return true;
    }
    light(handleAt(pointer));
    return lit_.has_value();
}

void MarksLayer::leave() {
    pointer_.reset();
    light(std::nullopt);
}

void MarksLayer::light(const std::optional<MarkHandle>& handle) {
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
    if (drawing_) {
        emit drawingCancelled();
        return true;
    }
    const bool moved = std::exchange(dragging_, false) || loose_;
    if (!std::exchange(dragged_, std::nullopt) && !moved)
        return false;
    putBack();
    if (moved)
        emit dragCancelled();
    return true;
}

std::optional<Qt::CursorShape> MarksLayer::cursor() const {
    if (drawing_ && elsewhere_)
        return Qt::ForbiddenCursor;
    if (drawing_ && (slice_ || !isFlat(drawn_.shape)))
        return Qt::CrossCursor;
    return lit_ || dragged_ ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

void MarksLayer::paint(QPainter& painter, const ImagePlace& image) const {
    if (!image.camera)
        return;
    MarkPainter marks(painter, image, slice_);
    for (const ShownMark& mark : marks_) {
        const auto hidden = hidden_.find(mark.id);
        marks.paint(loose_ ? movedTo(mark, *loose_, image, looseAt_) : mark,
                    lit_ && lit_->id == mark.id ? lit_->index : -1,
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
