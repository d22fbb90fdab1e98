#include "ui/slices/slice_view.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "ui/annotation/slice_camera.h"

namespace pdr::ui {
namespace {

/// Every movement counts: a click of these tools does nothing.
constexpr double kNoTremble = 0;

QString nameOf(AnatomicalPlane plane) {
    switch (plane) {
        case AnatomicalPlane::axial:
            return SliceView::tr("Axial slice");
        case AnatomicalPlane::coronal:
            return SliceView::tr("Coronal slice");
        case AnatomicalPlane::sagittal:
            break;
    }
    return SliceView::tr("Sagittal slice");
}

}  // namespace

SliceView::SliceView(AnatomicalPlane plane, QWidget* parent)
    : QWidget(parent), plane_(plane), window_(kTremble), pan_(kNoTremble), zoom_(kNoTremble) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setAccessibleName(nameOf(plane));
    setAccessibleDescription(
        tr("Up and down scroll by a slice, Page up and Page down by ten, digits choose a window. Shift with the arrows "
           "moves the crosshair, Enter clicks there."));
    bindTools();
}

void SliceView::bindTools() {
    tools_.add(keys_);
    tools_.bind(Qt::LeftButton, Qt::NoModifier, point_);
    tools_.bind(Qt::LeftButton, Qt::ShiftModifier, pan_);
    tools_.bind(Qt::MiddleButton, Qt::NoModifier, pan_);
    tools_.bind(Qt::RightButton, Qt::NoModifier, window_);
    tools_.bind(Qt::RightButton, Qt::ControlModifier, zoom_);
    connect(&tools_, &ViewTools::changed, this, &SliceView::followTools);
    connect(&keys_, &SliceKeys::stepped, this, &SliceView::stepped);
    connect(&keys_, &SliceKeys::nudged, this, &SliceView::nudged);
    connect(&keys_, &SliceKeys::clicked, this, &SliceView::clickCrosshair);
    connect(&keys_, &SliceKeys::windowChosen, this, &SliceView::windowChosen);
    connect(&keys_, &SliceKeys::zoomed, this, [this](double factor, QPointF place) {
        if (slice_)
            emit zoomed(factor, mmAt(place));
    });
    connect(&point_, &PointTool::pointed, this, [this](QPointF place) {
        if (slice_)
            emit pointed(mmAt(place));
    });
    connect(&window_, &DragTool::dragged, this,
            [this](QPointF, QPointF step) { emit windowDragged(step.x(), -step.y()); });
    connect(&window_, &DragTool::clicked, this, [this](QPointF at) {
        emit menuRequested(place().inPixels({at, at}).topLeft().toPoint());
    });
    connect(&pan_, &DragTool::dragged, this, [this](QPointF, QPointF step) {
        if (slice_)
            emit panned(dvec2(step.x(), step.y()) * slice_->plane.mmPerPixel * double(slice_->plane.size.y));
    });
    connect(&zoom_, &DragTool::dragged, this, [this](QPointF, QPointF step) {
        if (slice_)
            emit zoomed(std::exp(-4 * step.y()), slice_->plane.middleMm());
    });
}

void SliceView::followTools() {
    if (cursor().shape() != tools_.cursor())
        setCursor(tools_.cursor());
    update();
}

ivec2 SliceView::sizeInPixels() const {
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    return {pixels.width(), pixels.height()};
}

void SliceView::setSlice(const ShownSlice& slice) {
    slice_ = slice;
    changePlace();
}

void SliceView::clear() {
    slice_.reset();
    pointed_.clear();
    changePlace();
}

void SliceView::setCrosshair(dvec3 placeMm) {
    crosshairMm_ = placeMm;
    update();
}

void SliceView::setPointed(const QString& text) {
    if (text == pointed_)
        return;
    pointed_ = text;
    update();
}

/// Does what a click of the left button at the crosshair does.
void SliceView::clickCrosshair(Qt::KeyboardModifiers modifiers) {
    if (!slice_)
        return;
    const dvec2 at = (slice_->plane.pixelAt(crosshairMm_) + 0.5) / dvec2(slice_->plane.size);
    ViewPointer pointer{{at.x * width(), at.y * height()}, Qt::LeftButton, Qt::LeftButton, modifiers, false, place()};
    tools_.press(pointer);
    pointer.held = Qt::NoButton;
    tools_.release(pointer);
}

void SliceView::changePlace() {
    tools_.setImage(place());
    update();
}

ImagePlace SliceView::place() const {
    return {size(), rect(), slice_ ? std::optional(cameraFacing(slice_->plane)) : std::nullopt};
}

/// Returns the place at fractions of the slice's width and height.
dvec3 SliceView::mmAt(QPointF fractions) const {
    return slice_->plane.mmAt(dvec2(fractions.x(), fractions.y()) * dvec2(slice_->plane.size) - 0.5);
}

/// Keeps keys that the slice uses from being shortcuts of the window, such as the digits.
bool SliceView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && key->key() >= Qt::Key_0 && key->key() <= Qt::Key_9)
            event->accept();
    }
    if (event->type() == QEvent::Leave) {
        tools_.leave();
        emit hovered(std::nullopt);
    }
    return QWidget::event(event);
}

void SliceView::resizeEvent(QResizeEvent*) {
    changePlace();
    emit resized();
}

/// Takes the keyboard from another view, but not from a field in which the user types.
void SliceView::enterEvent(QEnterEvent*) {
    const QWidget* focus = window()->focusWidget();
    if (focus && focus->parentWidget() == parentWidget())
        setFocus(Qt::MouseFocusReason);
}

void SliceView::mousePressEvent(QMouseEvent* event) {
    tools_.press(pointerOf(*event, place()));
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
    tools_.move(pointerOf(*event, place()));
    if (slice_)
        emit hovered(mmAt(place().fractionsAt(event->position())));
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
    tools_.release(pointerOf(*event, place()));
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
    const ViewPointer pointer = pointerOf(*event, place());
    const bool plain = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
    if (plain && !tools_.take(pointer))
        emit aloneRequested();
    else
        tools_.press(pointer);
}

/// Opens the menu by its key only. The mouse's context menu event comes with the press, which may begin a drag.
void SliceView::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() != QContextMenuEvent::Mouse)
        emit menuRequested(rect().center());
}

void SliceView::wheelEvent(QWheelEvent* event) {
    tools_.wheel(pointerOf(*event, place()), clicksOf(*event));
}

void SliceView::keyPressEvent(QKeyEvent* event) {
    if (!tools_.key(*event))
        QWidget::keyPressEvent(event);
}

void SliceView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!slice_)
        return;
    painter.setFont(font());
    ShownSlice shown = *slice_;
    if (!pointed_.isEmpty())
        shown.texts.prepend(pointed_);
    paintSlice(painter, shown, size());
    paintCrosshair(painter, *slice_, plane_, crosshairMm_, size());
    if (hasFocus()) {
        painter.setPen(QPen(palette().highlight().color(), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    tools_.paint(painter);
}

}  // namespace pdr::ui
