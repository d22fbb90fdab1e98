#pragma once
/// The looks to choose from, as the window shows them, with their pictures.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// What there is to choose from.
void showLooks(const DesktopParts& parts);
/// Orders the pictures of the looks for the view as it is; while it moves there are none.
void orderLookPictures(const DesktopParts& parts, bool moving);
/// A picture has come. Of the first one the brightness of its look is taken.
void showLookPicture(const DesktopParts& parts, int look, const QImage& picture, double stops);

}  // namespace pdr::app
