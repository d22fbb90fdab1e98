#include "ui/slices/shown_slice.h"

#include "ui/annotation/annotations.h"
#include "ui/annotation/slice_camera.h"
#include "ui/slices/plane_pen.h"

namespace pdr::ui {
namespace {

constexpr double kGap = 10;  ///< half of the crosshair's gap [px]

/// The planes whose lines run from side to side and from top to bottom in a slice of `plane`.
std::pair<AnatomicalPlane, AnatomicalPlane> crossing(AnatomicalPlane plane) {
    switch (plane) {
        case AnatomicalPlane::axial:
            return {AnatomicalPlane::coronal, AnatomicalPlane::sagittal};
        case AnatomicalPlane::coronal:
            return {AnatomicalPlane::axial, AnatomicalPlane::sagittal};
        case AnatomicalPlane::sagittal:
            break;
    }
    return {AnatomicalPlane::axial, AnatomicalPlane::coronal};
}

}  // namespace

void paintSlice(QPainter& painter, const ShownSlice& slice, const QSize& size) {
    // Qt 6's smooth stretching shifts an image by half a pixel of the screen. A coarse pixel covers exactly two by two.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !slice.isCoarse());
    const dvec2 pixels = dvec2(slice.plane.size) / (slice.isCoarse() ? 2.0 : 1.0);
    painter.drawImage(QRectF(QPointF(), size), slice.image, QRectF(0, 0, pixels.x, pixels.y));
    paintAnnotations(painter, {cameraFacing(slice.plane), {}, slice.texts, false}, size);
}

void paintCrosshair(QPainter& painter, const ShownSlice& slice, AnatomicalPlane plane, dvec3 placeMm,
                    const QSize& size) {
    const dvec2 perPixel = dvec2(size.width(), size.height()) / dvec2(slice.plane.size);
    const dvec2 at = (slice.plane.pixelAt(placeMm) + 0.5) * perPixel;
    const auto [across, down] = crossing(plane);
    const double reach = size.width() + size.height();
    const auto drawLine = [&](AnatomicalPlane other, dvec2 direction) {
        const dvec2 along = glm::normalize(direction * perPixel);
        painter.setPen(planePen(other));
        for (const double side : {-1.0, 1.0}) {
            const dvec2 from = at + side * kGap * along, to = at + side * reach * along;
            painter.drawLine(QPointF(from.x, from.y), QPointF(to.x, to.y));
        }
    };
    drawLine(across, slice.lineAcross);
    drawLine(down, slice.lineDown);
}

}  // namespace pdr::ui
