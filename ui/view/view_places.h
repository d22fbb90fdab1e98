#pragma once
/// Places of the patient in a view that shows a slice or an image.

#include <optional>

#include "ui/view/image_place.h"

namespace pdr::ui {

/// Returns where a place is seen in the view [px]; none: behind the eye, or the view has no image.
std::optional<QPointF> seenAt(const ImagePlace& image, dvec3 placeMm);
/// Returns the place under a point of the view [px] at `depthMm` behind the plane of the view's target: in a slice, at
/// 0, the place of the slice. The view must have an image.
dvec3 placeUnder(const ImagePlace& image, QPointF point, double depthMm = 0);
/// Returns the length that a pixel of the view shows at a place's depth [mm]; 0 at and behind the eye. The view must
/// have an image.
double mmPerPixel(const ImagePlace& image, dvec3 placeMm);
/// Returns how far a place lies behind the plane of the view's target [mm]; negative: before it.
double depthMm(const ImagePlace& image, dvec3 placeMm);

}  // namespace pdr::ui
