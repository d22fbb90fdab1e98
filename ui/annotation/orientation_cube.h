#pragma once
/// A small cube in the corner of the view whose faces carry the patient's sides, turned as the patient is.

#include <QPainter>
#include <QRectF>

#include "render/scene/camera.h"

namespace pdr::ui {

/// Paints the cube of `camera`'s view into `area` (square).
void paintOrientationCube(QPainter& painter, const QRectF& area, const Camera& camera);

}  // namespace pdr::ui
