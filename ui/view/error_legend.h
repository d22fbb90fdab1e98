#pragma once
/// What the colours of the error map mean, painted on the picture.

#include <QPainter>

namespace pdr::ui {

/// In the upper left corner of `area`. `beforeDenoising`: the image is denoised, and the map is of what it was
/// before.
void paintErrorLegend(QPainter& painter, const QRect& area, bool beforeDenoising);

}  // namespace pdr::ui
