#include "ui/view/viewport.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <chrono>

#include "render/scene/orbit.h"

namespace pdr::ui {
namespace {

constexpr auto kSettledAfter = std::chrono::milliseconds(200);

}  // namespace

Viewport::Viewport(QWidget* parent)
    : QWidget(parent), orbit_(camera_, orbited), pan_(camera_, panned), zoom_(camera_, zoomedByDrag), steps_(camera_) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::ArrowCursor);
    setMouseTracking(true);  // to notice when the pointer moves on
    setAccessibleName(tr("Image"));
    setAccessibleDescription(
        tr("The rendered volume. Arrow keys turn it, Shift and arrow keys move it, plus and minus zoom."));
    settleTimer_.setSingleShot(true);
    settleTimer_.setInterval(kSettledAfter);
    connect(&settleTimer_, &QTimer::timeout, this, [this] { emit sizeInPixelsChanged(sizeInPixels()); });
    bindTools();
    forwardTools();
}

/// Sets which gesture a button and modifiers begin.
void Viewport::bindTools() {
    tools_.add(steps_);
    tools_.bind(Qt::LeftButton, Qt::ShiftModifier, pan_);
    tools_.bind(Qt::LeftButton, Qt::NoModifier, orbit_);
    tools_.bind(Qt::MiddleButton, Qt::NoModifier, pan_);
    tools_.bind(Qt::RightButton, Qt::NoModifier, zoom_);
}

/// Reports what the tools do as signals of the view.
void Viewport::forwardTools() {
    connect(&tools_, &ViewTools::changed, this, &Viewport::followTools);
    connect(&camera_, &EditedCamera::edited, this, &Viewport::cameraEdited);
    connect(&zoom_, &CameraDrag::clicked, this, [this](QPointF place) { emit menuRequested(place.toPoint()); });
    connect(&orbit_, &CameraDrag::clicked, this, [this](QPointF at) {
        if (image_)
            emit clicked(place().fractionsAt(at));
    });
}

void Viewport::followTools() {
    if (cursor().shape() != tools_.cursor())
        setCursor(tools_.cursor());
    update();
}

void Viewport::setImage(const ShownImage& picture) {
    image_ = picture;
    tools_.setImage(place());
    update();
}

void Viewport::clearImage() {
    image_.reset();
    tools_.setImage(place());
    update();
}

EdgeLetters Viewport::letters() const {
    return image_ ? edgeLetters(image_->camera) : EdgeLetters{};
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

std::optional<QPointF> Viewport::fractionsAt(QPoint at) const {
    const QPointF fractions = place().fractionsAt(at);
    const bool inside = image_ && QRectF(0, 0, 1, 1).contains(fractions);
    return inside ? std::optional(fractions) : std::nullopt;
}

ImagePlace Viewport::place() const {
    if (!image_ || image_->image.isNull())
        return {size(), rect(), std::nullopt};
    return {size(), imageArea(image_->image.size(), {size(), devicePixelRatioF()}), image_->camera};
}

void Viewport::tellPlace(const QHelpEvent& event) {
    if (!image_ || tools_.inGesture())
        return;
    resting_ = place().fractionsAt(event.pos());
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
    if (event->type() == QEvent::Leave) {
        resting_.reset();
        tools_.leave();
    }
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
    tools_.setImage(place());
    if (image_)
        settleTimer_.start();
    else
        emit sizeInPixelsChanged(sizeInPixels());
}

void Viewport::press(const QMouseEvent& event) {
    tools_.press(pointerOf(event, place()));
    if (tools_.inGesture())
        camera_.hold();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    press(*event);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    press(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    resting_.reset();
    tools_.move(pointerOf(*event, place()));
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    tools_.release(pointerOf(*event, place()));
    if (!tools_.inGesture())
        camera_.letGo();
}

/// Opens the menu by its key only. The mouse's context menu event comes with the press, which may begin a drag.
void Viewport::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() != QContextMenuEvent::Mouse)
        emit menuRequested(rect().center());
}

void Viewport::wheelEvent(QWheelEvent* event) {
    tools_.wheel(pointerOf(*event, place()), clicksOf(*event));
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (camera_.get() && event->key() == Qt::Key_Home)
        return emit resetRequested();
    if (!tools_.key(*event))
        QWidget::keyPressEvent(event);
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
    painter.save();
    if (image_)
        paintImage(painter);
    else
        paintMessage(painter);
    painter.restore();
    tools_.paint(painter);
}

void Viewport::paintImage(QPainter& painter) const {
    painter.setFont(font());
    paintShownImage(painter, *image_, {size(), devicePixelRatioF(), captionShown_, overlay_()});
    if (reachedByKey_)
        paintRing(painter);
}

void Viewport::paintMessage(QPainter& painter) const {
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.4);
    painter.setFont(large);
    painter.setPen(QColor(175, 175, 175));
    painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, message_);
}

}  // namespace pdr::ui
