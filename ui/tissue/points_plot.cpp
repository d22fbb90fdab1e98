#include "ui/tissue/points_plot.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <chrono>
#include <cmath>
#include <utility>

namespace pdr::ui {
namespace {

constexpr double kZoomPerWheelClick = 1.25;
constexpr float kFar = 10;  ///< a nudge with Shift, in steps
constexpr auto kRestAfter = std::chrono::milliseconds(400);

}  // namespace

PointsPlot::PointsPlot(CurveHand::Kind kind, QWidget* parent) : QWidget(parent), hand_(kind) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);  // for the shape of the cursor
    restTimer_.setSingleShot(true);
    restTimer_.setInterval(kRestAfter);
    connect(&restTimer_, &QTimer::timeout, this, [this] { edit(false); });
}

void PointsPlot::setPoints(const Curve& points, float top) {
    if (points != hand_.curve())
        restTimer_.stop();
    hand_.setCurve(points, top);
    update();
}

void PointsPlot::setArea(const QRectF& area) {
    view_.setArea(area);
    update();
}

void PointsPlot::setShownTop(double top) {
    view_.setTop(top);
    update();
}

void PointsPlot::setRange(double lowHu, double highHu) {
    view_.show(lowHu, highHu);
    update();
}

void PointsPlot::clearSelection() {
    hand_.select({});
    update();
}

void PointsPlot::edit(bool moving) {
    update();
    emit edited(moving);
}

/// Ends a gesture of keys before another one begins.
void PointsPlot::rest() {
    if (!restTimer_.isActive())
        return;
    restTimer_.stop();
    edit(false);
}

void PointsPlot::nudge(const CurvePoint& by) {
    if (!hand_.nudge(by))
        return;
    pointsMoved();
    restTimer_.start();
    edit(true);
}

void PointsPlot::removeSelected() {
    rest();
    const CurveSelection removed = hand_.selection();
    if (!hand_.removeSelected())
        return;
    pointsRemoved(removed);
    edit(false);
    emit selectionChanged();
}

void PointsPlot::add() {
    rest();
    hand_.addAfterSelected();
    pointAdded(hand_.selection().front());
    edit(false);
    emit selectionChanged();
}

void PointsPlot::mousePressEvent(QMouseEvent* event) {
    rest();
    if (event->button() == Qt::MiddleButton)
        panning_ = event->position();
    if (event->button() != Qt::LeftButton)
        return;
    if (hand_.press(view_, event->position(), event->modifiers())) {
        pointAdded(hand_.selection().front());
        edit(true);
    }
    update();
    emit selectionChanged();
}

void PointsPlot::mouseMoveEvent(QMouseEvent* event) {
    if (panning_) {
        view_.pan(event->position().x() - panning_->x());
        panning_ = event->position();
        update();
        emit rangeChanged(view_.lowHu(), view_.highHu());
    } else if (!hand_.isHolding()) {
        showCursorFor(event->position());
    } else if (hand_.drag(view_, event->position())) {
        pointsMoved();
        edit(true);
    } else {
        update();
        emit selectionChanged();
    }
}

void PointsPlot::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton)
        panning_.reset();
    if (event->button() == Qt::LeftButton && hand_.release())
        edit(false);
    update();
}

void PointsPlot::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!hand_.pointAt(view_, event->position()) && !hand_.isOnLine(view_, event->position()))
        emit fitRequested();
}

void PointsPlot::showCursorFor(QPointF place) {
    const bool onPoint = hand_.pointAt(view_, place).has_value();
    setCursor(onPoint ? Qt::SizeAllCursor : hand_.isOnLine(view_, place) ? Qt::CrossCursor : Qt::ArrowCursor);
}

void PointsPlot::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    if (event->modifiers().testFlag(Qt::ShiftModifier))
        return zoomValues((turned.y() + turned.x()) / 120.0);
    zoom(event->position().x(), std::pow(kZoomPerWheelClick, turned.y() / 120.0));
}

void PointsPlot::zoom(double x, double factor) {
    view_.zoom(x, factor);
    update();
    emit rangeChanged(view_.lowHu(), view_.highHu());
}

/// Ignores keys while the mouse drags, so that they cannot remove the points that it holds.
void PointsPlot::keyPressEvent(QKeyEvent* event) {
    if (hand_.isHolding() || panning_)
        return;
    if (!moveOrChoose(*event) && !changeOrZoom(*event))
        QWidget::keyPressEvent(event);
}

bool PointsPlot::moveOrChoose(const QKeyEvent& event) {
    const float times = event.modifiers().testFlag(Qt::ShiftModifier) ? kFar : 1;
    const auto choose = [&](int step) {
        hand_.selectNext(step);
        update();
        emit selectionChanged();
    };
    switch (event.key()) {
        case Qt::Key_Left:
            return nudge({-times * step().hu, 0}), true;
        case Qt::Key_Right:
            return nudge({times * step().hu, 0}), true;
        case Qt::Key_Up:
            return nudge({0, times * step().value}), true;
        case Qt::Key_Down:
            return nudge({0, -times * step().value}), true;
        case Qt::Key_PageUp:
            return choose(-1), true;
        case Qt::Key_PageDown:
            return choose(1), true;
        default:
            return false;
    }
}

bool PointsPlot::changeOrZoom(const QKeyEvent& event) {
    if (event.matches(QKeySequence::SelectAll)) {
        hand_.selectAll();
        update();
        emit selectionChanged();
        return true;
    }
    switch (event.key()) {
        case Qt::Key_Insert:
            return add(), true;
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return removeSelected(), true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoom(view_.area().center().x(), kZoomPerWheelClick), true;
        case Qt::Key_Minus:
            return zoom(view_.area().center().x(), 1 / kZoomPerWheelClick), true;
        case Qt::Key_Home:
            emit fitRequested();
            return true;
        default:
            return false;
    }
}

bool PointsPlot::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
    return true;
}

void PointsPlot::paintFocus(QPainter& painter) const {
    if (!hasFocus())
        return;
    painter.setPen(QPen(palette().color(QPalette::Link), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

}  // namespace pdr::ui
