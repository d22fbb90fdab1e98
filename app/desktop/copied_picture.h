#pragma once
/// The picture on the screen for other programs: its pixels and its annotations, and nothing of whom it shows.

#include <QImage>
#include <optional>

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// `frame`, which has a picture, with `annotations` over it and whether it is unfinished. A coarse one is stretched to
/// `fullSize` [pixels].
QImage copyOf(const Frame& frame, ivec2 fullSize, const std::optional<ui::Annotations>& annotations);

/// Puts the picture on the clipboard and says so; does nothing where there is none.
void copyPicture(const DesktopParts& parts);

}  // namespace pdr::app
