#pragma once
/// The legend that explains the colours of the error map on the image.

#include <QPainter>

namespace pdr::ui {

/// Paints the legend into the upper left corner of `area`, where nothing else may stand. `beforeDenoising`: the image
/// is denoised, but the map shows the error before denoising.
void paintErrorLegend(QPainter& painter, const QRect& area, bool beforeDenoising);

}  // namespace pdr::ui
