#include "ui/view/viewport.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <chrono>
#include <cmath>
#include <utility>

#include "render/scene/orbit.h"

namespace pdr::ui {
namespace {

constexpr double kKeyStep = 1.0 / 24;  // of the view's height: 7.5 degrees
constexpr double kZoomPerWheelClick = 1.15;
constexpr double kZoomPerHeight = 8;  // magnification of a drag over the whole height
constexpr double kTremble = 3;        // pointer movement that still counts as a click [px]
constexpr auto kRestAfter = std::chrono::milliseconds(250);
constexpr auto kSettledAfter = std::chrono::milliseconds(200);

}  // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::ArrowCursor);
    setMouseTracking(true);  // to notice when the pointer moves on
    setAccessibleName(tr("Image"));
    setAccessibleDescription(
        tr("The rendered volume. Arrow keys turn it, Shift and arrow keys move it, plus and minus zoom."));
    restTimer_.setSingleShot(true);
    restTimer_.setInterval(kRestAfter);
    connect(&restTimer_, &QTimer::timeout, this, &Viewport::rest);
    settleTimer_.setSingleShot(true);
    settleTimer_.setInterval(kSettledAfter);
    connect(&settleTimer_, &QTimer::timeout, this, [this] { emit sizeInPixelsChanged(sizeInPixels()); });
}

void Viewport::setPicture(const ShownPicture& picture) {
    picture_ = picture;
    update();
}

void Viewport::clearPicture() {
    picture_.reset();
    update();
}

EdgeLetters Viewport::letters() const {
    return picture_ ? edgeLetters(picture_->camera) : EdgeLetters{};
}

void Viewport::setCamera(const std::optional<Camera>& camera) {
    camera_ = camera;
    if (!camera_)
        moved_ = false;
}

void Viewport::setCaptionShown(bool shown) {
    captionShown_ = shown;
    update();
}

void Viewport::setMessage(const QString& message) {
    message_ = message;
    update();
}

QSize Viewport::sizeInPixels() const {
    return (QSizeF(size()) * devicePixelRatioF()).toSize();
}

void Viewport::showTip(QPointF place, const QString& text) {
    if (resting_ == place)
        QToolTip::showText(restingAt_, text, this, QRect(mapFromGlobal(restingAt_), QSize(1, 1)));
}

/// Returns a point of the view in fractions of the image's width and height.
QPointF Viewport::placeOf(QPointF point) const {
    const QRectF area = pictureArea(picture_->image.size(), view());
    const QPointF place = point - area.topLeft();
    return {place.x() / area.width(), place.y() / area.height()};
}

void Viewport::setPicking(Picking picking) {
    picking_ = picking;
    setCursor(picking != Picking::nothing ? Qt::CrossCursor : Qt::ArrowCursor);
    emit pickingChanged(picking);
}

void Viewport::dragTissue(QPointF point) {
    tissueMoved_ = tissueMoved_ || QLineF(pressed_, point).length() > kTremble;
    const dvec2 drag = inHeights(point - pressed_);
    if (tissueMoved_ && picking_ == Picking::nothing)
        emit tissueDragged({drag.x, drag.y}, true);
}

void Viewport::endTissue(QPointF point) {
    const dvec2 drag = inHeights(point - pressed_);
    if (std::exchange(tissueMoved_, false) && picking_ == Picking::nothing)
        return emit tissueDragged({drag.x, drag.y}, false);
    if (!picture_)
        return;
    if (picking_ == Picking::focus)
        emit focusPicked(placeOf(point));
    else
        emit tissuePicked(placeOf(point));
}

void Viewport::tellPlace(const QHelpEvent& event) {
    if (!picture_ || gesture_ != Gesture::none)
        return;
    resting_ = placeOf(event.pos());
    restingAt_ = event.globalPos();
    if (QRectF(0, 0, 1, 1).contains(*resting_))
        emit rested(*resting_);
}

/// Handles tool tips, and screen changes: a screen with another pixel ratio changes the size in pixels, too.
bool Viewport::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        tellPlace(*static_cast<QHelpEvent*>(event));
        return true;
    }
    if (event->type() == QEvent::Leave)
        resting_.reset();
    if (event->type() == QEvent::ScreenChangeInternal)
        changeSize();
    return QWidget::event(event);
}

/// Marks the focus only if it came by Tab, for users who work with keys.
void Viewport::focusInEvent(QFocusEvent* event) {
    reachedByKey_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QWidget::focusInEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    reachedByKey_ = false;
    QWidget::focusOutEvent(event);
}

void Viewport::resizeEvent(QResizeEvent*) {
    changeSize();
}

/// Reports the new size. While an image is shown, waits until the size has settled: the sizes in between, e.g. while
/// the window is resized or panels open, are not worth rendering.
void Viewport::changeSize() {
    if (picture_)
        settleTimer_.start();
    else
        emit sizeInPixelsChanged(sizeInPixels());
}

Viewport::Gesture Viewport::gestureOf(const QMouseEvent& event) {
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    switch (event.button()) {
        case Qt::LeftButton:
            if (event.modifiers().testFlag(Qt::ControlModifier))
                return Gesture::tissue;
            return shift ? Gesture::pan : Gesture::orbit;
        case Qt::MiddleButton:
            return Gesture::pan;
        case Qt::RightButton:
            return shift ? Gesture::light : Gesture::zoom;
        default:
            return Gesture::none;
    }
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (gesture_ != Gesture::none)
        return;
    gesture_ = picking_ != Picking::nothing && event->button() == Qt::LeftButton ? Gesture::tissue : gestureOf(*event);
    last_ = pressed_ = event->position();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    resting_.reset();
    if (!camera_ || gesture_ == Gesture::none)
        return;
    const dvec2 drag = inHeights(event->position() - last_);
    last_ = event->position();
    switch (gesture_) {
        case Gesture::orbit:
            return edit(orbited(*camera_, drag));
        case Gesture::pan:
            return edit(panned(*camera_, drag));
        case Gesture::zoom:
            return edit(zoomed(*camera_, std::pow(kZoomPerHeight, -drag.y)));
        case Gesture::tissue:
            return dragTissue(event->position());
        case Gesture::light:
            return emit lightDragged({drag.x, drag.y}, true);
        case Gesture::none:
            return;
    }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton)
        return;
    const Gesture ended = std::exchange(gesture_, Gesture::none);
    if (ended == Gesture::zoom && QLineF(pressed_, event->position()).length() <= kTremble)
        emit menuRequested(event->position().toPoint());
    if (ended == Gesture::tissue)
        endTissue(event->position());
    if (ended == Gesture::light)
        emit lightDragged({0, 0}, false);
    rest();
}

/// Opens the menu by its key only. The mouse's context menu event comes with the press, which may begin a drag.
void Viewport::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() != QContextMenuEvent::Mouse)
        emit menuRequested(rect().center());
}

/// Zooms so that the point under the pointer stays under it.
void Viewport::wheelEvent(QWheelEvent* event) {
    if (!camera_)
        return;
    const double factor = std::pow(kZoomPerWheelClick, event->angleDelta().y() / 120.0);
    const dvec2 cursor = inHeights(event->position() - QRectF(rect()).center());
    editInSteps(panned(zoomed(*camera_, factor), cursor * (1 - factor)));
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (!camera_)
        return QWidget::keyPressEvent(event);
    const auto turnOrMove = [&](dvec2 drag) {
        const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
        editInSteps(shift ? panned(*camera_, drag) : orbited(*camera_, drag));
    };
    switch (event->key()) {
        case Qt::Key_Left:
            return turnOrMove({-kKeyStep, 0});
        case Qt::Key_Right:
            return turnOrMove({kKeyStep, 0});
        case Qt::Key_Up:
            return turnOrMove({0, -kKeyStep});
        case Qt::Key_Down:
            return turnOrMove({0, kKeyStep});
        case Qt::Key_Home:
            return emit resetRequested();
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return editInSteps(zoomed(*camera_, kZoomPerWheelClick));
        case Qt::Key_Minus:
            return editInSteps(zoomed(*camera_, 1 / kZoomPerWheelClick));
        default:
            QWidget::keyPressEvent(event);
    }
}

void Viewport::edit(const Camera& camera) {
    camera_ = camera;
    moved_ = true;
    emit cameraEdited(camera, true);
}

void Viewport::editInSteps(const Camera& camera) {
    edit(camera);
    restTimer_.start();
}

void Viewport::rest() {
    if (gesture_ != Gesture::none || !moved_)
        return;
    restTimer_.stop();
    moved_ = false;
    emit cameraEdited(*camera_, false);
}

dvec2 Viewport::inHeights(QPointF distance) const {
    return dvec2(distance.x(), distance.y()) / double(std::max(height(), 1));
}

/// Paints the focus ring, which is visible on the black ground and on bright tissue.
void Viewport::paintRing(QPainter& painter) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
    painter.setPen(Qt::black);
    painter.drawRect(rect().adjusted(2, 2, -3, -3));
}

void Viewport::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!picture_)
        return paintMessage(painter);
    painter.setFont(font());
    paintShownPicture(painter, *picture_, view());
    if (reachedByKey_)
        paintRing(painter);
}

PictureView Viewport::view() const {
    return {size(), devicePixelRatioF(), captionShown_, overlay_()};
}

void Viewport::paintMessage(QPainter& painter) const {
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.4);
    painter.setFont(large);
    painter.setPen(QColor(175, 175, 175));
    painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, message_);
}

}  // namespace pdr::ui
