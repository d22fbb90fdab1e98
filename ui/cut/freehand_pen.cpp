#include "ui/cut/freehand_pen.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "render/scene/edit/drawn_outline.h"
#include "ui/view/shown_picture.h"

namespace pdr::ui {
namespace {

constexpr double kLeastSide = 8;      ///< least side of the line's bounding box [px]; a smaller one counts as a click
constexpr double kStep = 2;           ///< least distance between corners [px]
constexpr double kTolerancePx = 0.7;  ///< error allowed by leaving out a corner

}  // namespace

FreehandPen::FreehandPen(QWidget* picture)
    : PictureLayer(picture), answers_(this), remove_(tr("Remove inside")), keep_(tr("Keep inside")) {
    remove_.setToolTip(tr("Remove the tissue inside the outline (Del)"));
    keep_.setToolTip(tr("Keep only the tissue inside the outline (K)"));
    remove_.setShortcut(Qt::Key_Delete);
    keep_.setShortcut(Qt::Key_K);
    auto* row = new QHBoxLayout(&answers_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&remove_);
    row->addWidget(&keep_);
    for (QPushButton* button : {&remove_, &keep_})
        button->setCursor(Qt::ArrowCursor);
    answers_.hide();
    connect(&remove_, &QPushButton::clicked, this, [this] { answer(false); });
    connect(&keep_, &QPushButton::clicked, this, [this] { answer(true); });
}

void FreehandPen::setPicture(const Camera& camera, QSize size) {
    if (camera != camera_) {
        line_.clear();
        answers_.hide();
        update();
    }
    camera_ = camera;
    size_ = size;
}

void FreehandPen::stopDrawing() {
    pressed_ = false;
    line_.clear();
    answers_.hide();
    leaveMouse();
}

/// Begins a line; it replaces an earlier one.
void FreehandPen::mousePressEvent(QMouseEvent* event) {
    if (!camera_ || event->button() != Qt::LeftButton)
        return;
    answers_.hide();
    pressed_ = true;
    line_ = {event->position()};
}

void FreehandPen::mouseMoveEvent(QMouseEvent* event) {
    if (!pressed_ || line_.isEmpty() || (event->position() - line_.last()).manhattanLength() < kStep)
        return;
    line_ << event->position();
    update();
}

void FreehandPen::mouseReleaseEvent(QMouseEvent* event) {
    if (!std::exchange(pressed_, false))
        return;
    const QRectF around = line_.boundingRect();
    if (std::min(around.width(), around.height()) >= kLeastSide && !outline().empty())
        return ask(event->position().toPoint());
    stopDrawing();
    emit ended();
}

void FreehandPen::ask(QPoint place) {
    answers_.adjustSize();
    const QSize size = answers_.size();
    answers_.move(std::clamp(place.x() + 8, 0, std::max(width() - size.width(), 0)),
                  std::clamp(place.y() + 8, 0, std::max(height() - size.height(), 0)));
    answers_.show();
    remove_.setFocus();
    update();
}

void FreehandPen::answer(bool keepInside) {
    const FreehandCut cut{*camera_, outline(), keepInside};
    stopDrawing();
    parentWidget()->setFocus();
    emit ended();
    emit drawn(cut);
}

/// Returns the line's corners, from the image's middle, in fractions of its height.
std::vector<PicturePoint> FreehandPen::outline() const {
    const QRectF area = pictureArea(size_, {size(), devicePixelRatioF()});
    std::vector<PicturePoint> points;
    for (const QPointF& place : line_) {
        const QPointF away = (place - area.center()) / area.height();
        points.push_back({away.x(), away.y()});
    }
    return simplified(points, kTolerancePx / area.height());
}

void FreehandPen::paintEvent(QPaintEvent*) {
    if (line_.size() < 2)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor inside(kMarkColour);
    inside.setAlpha(30);
    painter.setPen(Qt::NoPen);
    painter.setBrush(inside);
    painter.drawPolygon(line_);
    drawMark(painter, line_, 1.5);
}

}  // namespace pdr::ui
