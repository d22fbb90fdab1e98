#include "ui/slices/crosshair_layer.h"

#include "ui/slices/plane_pen.h"
#include "ui/view/mark.h"
#include "ui/view/view_places.h"

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
    const auto middle = seenAt(image, *placeMm_);
    if (!middle)
        return;
    const double mm = mmPerPixel(image, *placeMm_);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Arm& arm : kArms)
        for (const double side : {-1.0, 1.0}) {
            const auto from = seenAt(image, *placeMm_ + side * kGap * mm * arm.direction),
                       to = seenAt(image, *placeMm_ + side * kReach * mm * arm.direction);
            if (from && to)
                drawMarkLine(
                    painter, *from, *to,
                    QPen(planePen(arm.plane).color(), 2, inFront_ == InFront::tissue ? Qt::DotLine : Qt::SolidLine));
        }
    if (inFront_ == InFront::cut) {
        painter.setPen(QPen(Qt::white, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(*middle, kGap, kGap);
    }
    if (!text_.isEmpty()) {
        const QPointF text = *middle + QPointF(kReach, kReach);
        painter.setPen(Qt::black);
        painter.drawText(text + QPointF(1, 1), text_);
        painter.setPen(Qt::white);
        painter.drawText(text, text_);
    }
}

}  // namespace pdr::ui
