#pragma once
/// A coarse image in a larger size, without the blocks of its pixels.

#include <QImage>

namespace pdr::ui {

/// `image`, of 4 bytes a pixel, in `size`, no smaller than its own, by cubic B-splines: smooth to the second
/// derivative, where interpolation by straight lines shows each pixel's edges. Even grey stays even, a ramp a ramp;
/// single pixels and edges are softer.
QImage upsampled(const QImage& image, QSize size);

}  // namespace pdr::ui
