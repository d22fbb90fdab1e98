#include "ui/view/region_box.h"

#include "ui/view/mark.h"
#include "ui/view/viewport.h"

namespace pdr::ui {
namespace {

constexpr double kLeastSide = 6;  ///< least side of a box [px]; a smaller one counts as a click

}  // namespace

RegionBox::RegionBox(Viewport* view) : DrawingTool(view) {
    view->tools().add(*this);
}

void RegionBox::setBox(const std::optional<QRectF>& box) {
    box_ = box;
    emit changed();
}

void RegionBox::press(const ViewPointer& pointer) {
    from_ = to_ = pointer.at;
}

void RegionBox::move(const ViewPointer& pointer) {
    to_ = pointer.at;
    emit changed();
}

void RegionBox::release(const ViewPointer& pointer) {
    if (!from_)
        return;
    to_ = pointer.at;
    const QRectF box = dragged(pointer.image);
    stopDrawing();
    if (box.width() < kLeastSide || box.height() < kLeastSide)
        reportNothing();
    else
        emit drawn(pointer.image.inFractions(box));
}

/// Returns the box that the drag has drawn so far, clipped to the image [px].
QRectF RegionBox::dragged(const ImagePlace& image) const {
    return QRectF(*from_, to_).normalized() & QRectF({}, QSizeF(image.view)) & image.area;
}

void RegionBox::paint(QPainter& painter, const ImagePlace& image) const {
    if (from_)
        drawMark(painter, dragged(image), 1);
    else if (box_)
        drawMark(painter, image.inPixels(*box_), 1);
}

}  // namespace pdr::ui
