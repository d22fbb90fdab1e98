#pragma once
/// Shows the looks to choose from in the window, with their images.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Fills the gallery with the document's looks.
void showLooks(const DesktopParts& parts);
/// Requests the images of the looks for the current view, and cancels them while it moves.
void orderLookPictures(const DesktopParts& parts, bool moving);
/// Shows the image of a look. The document takes the look's brightness from its first image.
void showLookPicture(const DesktopParts& parts, int look, const QImage& picture, double stops);

}  // namespace pdr::app
