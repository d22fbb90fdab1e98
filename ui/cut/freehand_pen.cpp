#include "ui/cut/freehand_pen.h"

#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "render/scene/edit/drawn_outline.h"
#include "ui/view/mark.h"

namespace pdr::ui {
namespace {

constexpr double kLeastSide = 8;      ///< least side of the line's bounding box [px]; a smaller one counts as a click
constexpr double kStep = 2;           ///< least distance between corners [px]
constexpr double kTolerancePx = 0.7;  ///< error allowed by leaving out a corner

}  // namespace

FreehandPen::FreehandPen(QWidget* view, QObject* parent)
    : DrawingTool(parent),
      answers_(new QWidget(view)),
      remove_(new QPushButton(tr("Remove inside"))),
      keep_(new QPushButton(tr("Keep inside"))) {
    remove_->setToolTip(tr("Remove the tissue inside the outline (Del)"));
    keep_->setToolTip(tr("Keep only the tissue inside the outline (K)"));
    remove_->setShortcut(Qt::Key_Delete);
    keep_->setShortcut(Qt::Key_K);
    auto* row = new QHBoxLayout(answers_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(remove_);
    row->addWidget(keep_);
    for (QPushButton* button : {remove_, keep_})
        button->setCursor(Qt::ArrowCursor);
    answers_->hide();
    connect(remove_, &QPushButton::clicked, this, [this] { answer(false); });
    connect(keep_, &QPushButton::clicked, this, [this] { answer(true); });
}

void FreehandPen::setImage(const ImagePlace& image) {
    if (image.camera != image_.camera) {
        discardLine();
        emit changed();
    }
    image_ = image;
}

void FreehandPen::discard() {
    pressed_ = false;
    discardLine();
}

void FreehandPen::discardLine() {
    line_.clear();
    answers_->hide();
}

/// Begins a line; it replaces an earlier one.
void FreehandPen::press(const ViewPointer& pointer) {
    if (!image_.camera || pointer.button != Qt::LeftButton)
        return;
    answers_->hide();
    pressed_ = true;
    line_ = {pointer.at};
}

void FreehandPen::move(const ViewPointer& pointer) {
    if (!pressed_ || line_.isEmpty() || (pointer.at - line_.last()).manhattanLength() < kStep)
        return;
    line_ << pointer.at;
    emit changed();
}

void FreehandPen::release(const ViewPointer& pointer) {
    if (!std::exchange(pressed_, false))
        return;
    const QRectF around = line_.boundingRect();
    if (std::min(around.width(), around.height()) >= kLeastSide && !outline().empty())
        return ask(pointer.at.toPoint());
    stopDrawing();
    emit ended();
}

void FreehandPen::ask(QPoint place) {
    answers_->adjustSize();
    const QSize size = answers_->size(), view = image_.view;
    answers_->move(std::clamp(place.x() + 8, 0, std::max(view.width() - size.width(), 0)),
                   std::clamp(place.y() + 8, 0, std::max(view.height() - size.height(), 0)));
    answers_->raise();
    answers_->show();
    remove_->setFocus();
    emit changed();
}

void FreehandPen::answer(bool keepInside) {
    const FreehandCut cut{*image_.camera, outline(), keepInside};
    stopDrawing();
    answers_->parentWidget()->setFocus();
    emit ended();
    emit drawn(cut);
}

/// Returns the line's corners, from the image's middle, in fractions of its height.
std::vector<ImagePoint> FreehandPen::outline() const {
    std::vector<ImagePoint> points;
    for (const QPointF& place : line_) {
        const QPointF away = (place - image_.area.center()) / image_.area.height();
        points.push_back({away.x(), away.y()});
    }
    return simplified(points, kTolerancePx / image_.area.height());
}

void FreehandPen::paint(QPainter& painter, const ImagePlace&) const {
    if (line_.size() < 2)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    QColor inside(kMarkColour);
    inside.setAlpha(30);
    painter.setPen(Qt::NoPen);
    painter.setBrush(inside);
    painter.drawPolygon(line_);
    drawMark(painter, line_, 1.5);
}

}  // namespace pdr::ui
