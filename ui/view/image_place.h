#pragma once
/// Where the image lies in its view, and the conversions between places on the screen and in the image.

#include <QRectF>
#include <QSize>
#include <optional>

#include "render/scene/camera.h"

namespace pdr::ui {

struct ImagePlace {
    QSize view;   ///< size of the view [px]
    QRectF area;  ///< part of the view that the image takes [px]; without an image, the whole view
    /// Camera of the image; none: there is no image. A slice has a parallel camera whose target lies in the slice.
    std::optional<Camera> camera;

    /// Converts a distance in the view [px] to fractions of the view's height.
    dvec2 inHeights(QPointF distance) const;
    /// Converts a place in the view [px] to fractions of the image's width and height.
    QPointF fractionsAt(QPointF place) const;
    /// Converts a box in the view [px] to fractions of the image's width and height.
    QRectF inFractions(const QRectF& box) const;
    /// Converts a box in fractions of the image's width and height to one in the view [px].
    QRectF inPixels(const QRectF& box) const;
};

}  // namespace pdr::ui
