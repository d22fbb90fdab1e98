#include "ui/slices/crosshair_layer.h"

#include "render/scene/edit/view_geometry.h"
#include "ui/slices/plane_pen.h"

namespace pdr::ui {
namespace {

constexpr double kReach = 22, kGap = 5;  ///< ends of a line, from the place [px]

/// A line of the crosshair: across the slices of `plane`.
struct Arm {
    AnatomicalPlane plane;
    dvec3 direction;
};
constexpr Arm kArms[] = {
    {AnatomicalPlane::axial, {0, 0, 1}}, {AnatomicalPlane::coronal, {0, 1, 0}}, {AnatomicalPlane::sagittal, {1, 0, 0}}};

}  // namespace

void CrosshairLayer::setPlace(const std::optional<dvec3>& placeMm) {
    if (placeMm == placeMm_)
        return;
    placeMm_ = placeMm;
    setInFront(InFront::unknown, {});
}

void CrosshairLayer::setInFront(InFront inFront, const QString& text) {
    inFront_ = inFront;
    text_ = text;
    emit changed();
}

void CrosshairLayer::paint(QPainter& painter, const ImagePlace& image) const {
    if (!placeMm_ || !image.camera)
        return;
    const ViewGeometry geometry(*image.camera, image.area.width() / image.area.height());
    const auto at = geometry.at(*placeMm_);
    if (!at)
        return;
    const auto inView = [&](dvec2 point) { return image.inPixels(QRectF(point.x, point.y, 0, 0)).topLeft(); };
    const QPointF middle = inView(*at);
    const double mmPerPixel = geometry.heightMm(*placeMm_) / image.area.height();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Arm& arm : kArms)
        for (const double side : {-1.0, 1.0}) {
            const auto from = geometry.at(*placeMm_ + side * kGap * mmPerPixel * arm.direction),
                       to = geometry.at(*placeMm_ + side * kReach * mmPerPixel * arm.direction);
            if (!from || !to)
                continue;
            QPen pen(planePen(arm.plane).color(), 2);
            pen.setStyle(inFront_ == InFront::tissue ? Qt::DotLine : Qt::SolidLine);
            painter.setPen(QPen(QColor(0, 0, 0, 150), 4));
            painter.drawLine(inView(*from), inView(*to));
            painter.setPen(pen);
            painter.drawLine(inView(*from), inView(*to));
        }
    if (inFront_ == InFront::cut) {
        painter.setPen(QPen(Qt::white, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(middle, kGap, kGap);
    }
    if (!text_.isEmpty()) {
        const QPointF text = middle + QPointF(kReach, kReach);
        painter.setPen(Qt::black);
        painter.drawText(text + QPointF(1, 1), text_);
        painter.setPen(Qt::white);
        painter.drawText(text, text_);
    }
}

}  // namespace pdr::ui
