#include "ui/view/image_place.h"

#include <algorithm>

namespace pdr::ui {

dvec2 ImagePlace::inHeights(QPointF distance) const {
    return dvec2(distance.x(), distance.y()) / double(std::max(view.height(), 1));
}

QPointF ImagePlace::fractionsAt(QPointF place) const {
    return {(place.x() - area.x()) / area.width(), (place.y() - area.y()) / area.height()};
}

QRectF ImagePlace::inFractions(const QRectF& box) const {
    return {fractionsAt(box.topLeft()), QSizeF(box.width() / area.width(), box.height() / area.height())};
}

QRectF ImagePlace::inPixels(const QRectF& box) const {
    return {area.x() + box.x() * area.width(), area.y() + box.y() * area.height(), box.width() * area.width(),
            box.height() * area.height()};
}

}  // namespace pdr::ui
