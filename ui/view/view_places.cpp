#include "ui/view/view_places.h"

#include "render/scene/edit/view_geometry.h"

namespace pdr::ui {
namespace {

ViewGeometry geometryOf(const ImagePlace& image) {
    return {*image.camera, image.area.width() / image.area.height()};
}

}  // namespace

std::optional<QPointF> seenAt(const ImagePlace& image, dvec3 placeMm) {
    if (!image.camera)
        return std::nullopt;
    const auto at = geometryOf(image).at(placeMm);
    if (!at)
        return std::nullopt;
    return image.inPixels(QRectF(at->x, at->y, 0, 0)).topLeft();
}

dvec3 placeUnder(const ImagePlace& image, QPointF point, double depthMm) {
    const QPointF fractions = image.fractionsAt(point);
    const SightLine line = geometryOf(image).under({fractions.x(), fractions.y()});
    const dvec3 forward = image.camera->forward();
    const double away = glm::dot(image.camera->targetMm - line.originMm, forward) + depthMm;
    return line.originMm + away / glm::dot(line.direction, forward) * line.direction;
}

double mmPerPixel(const ImagePlace& image, dvec3 placeMm) {
    return geometryOf(image).heightMm(placeMm) / image.area.height();
}

double depthMm(const ImagePlace& image, dvec3 placeMm) {
    return glm::dot(placeMm - image.camera->targetMm, image.camera->forward());
}

}  // namespace pdr::ui
