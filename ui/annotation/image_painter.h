#pragma once
/// What is painted over an image file, once it is known how good the image is.

#include <functional>
#include <optional>

#include "render/film/error/shown_status.h"
#include "render/film/file/image_file.h"
#include "ui/annotation/annotations.h"

namespace pdr::ui {

/// Paints `annotations`, and below them that the image is a preview where it is not within `target` levels, which were
/// wanted. No annotations: it paints nothing. Any thread's.
std::function<PaintOver(const ShownStatus&)> imagePainter(std::optional<Annotations> annotations, double target);

}  // namespace pdr::ui
