#pragma once
/// The clipboard image: the image on the screen with its annotations, without the patient's name.

#include <QImage>
#include <optional>

#include "render/session/session.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Returns the image of `frame`, which must have one, with `annotations` and a note if it is unfinished. A coarse image
/// is stretched to `fullSize` [pixels].
QImage copyOf(const Frame& frame, ivec2 fullSize, const std::optional<ui::Annotations>& annotations);

}  // namespace pdr::app
