#pragma once
/// Enlarging a coarse image without visible pixel blocks.

#include <QImage>

namespace pdr::ui {

/// Returns `image` (4 bytes per pixel) enlarged to `size`, which must not be smaller, with cubic B-splines. The result
/// is smooth to the second derivative, where linear interpolation shows the edges of each pixel. Uniform areas and
/// linear ramps are reproduced; single pixels and edges become softer.
QImage upsampled(const QImage& image, QSize size);

}  // namespace pdr::ui
