#pragma once
/// Places of the patient in a view that shows a slice or an image.

#include <optional>

#include "ui/view/view_tool.h"

namespace pdr::ui {

/// Returns where a place is seen in the view [px]; none: behind the eye, or the view has no image.
std::optional<QPointF> seenAt(const ImagePlace& image, dvec3 placeMm);
/// Returns the place in the plane of the view's target under a point of the view [px]: in a slice, the place of the
/// slice. The view must have an image.
dvec3 placeUnder(const ImagePlace& image, QPointF point);
/// Returns how far a place lies behind the plane of the view's target [mm]; negative: before it.
double depthMm(const ImagePlace& image, dvec3 placeMm);

}  // namespace pdr::ui
