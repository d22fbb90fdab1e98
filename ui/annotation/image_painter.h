#pragma once
/// Painting annotations over an image file once its accuracy is known.

#include <functional>
#include <optional>

#include "render/film/error/shown_status.h"
#include "render/film/file/image_file.h"
#include "ui/annotation/annotations.h"

namespace pdr::ui {

/// Returns a function that paints `annotations`, and below them that the image is a preview if it is not within the
/// requested `target` levels. No annotations: it paints nothing. Any thread may call it.
std::function<PaintOver(const ShownStatus&)> imagePainter(std::optional<Annotations> annotations, double target);

}  // namespace pdr::ui
