#pragma once
/// A small cube in the corner of the view with the letters of the patient's sides, in the patient's orientation.

#include <QPainter>
#include <QRectF>

#include "render/scene/camera.h"

namespace pdr::ui {

/// Paints the cube of `camera`'s view into `area` (square).
void paintOrientationCube(QPainter& painter, const QRectF& area, const Camera& camera);

}  // namespace pdr::ui
