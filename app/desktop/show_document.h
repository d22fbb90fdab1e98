#pragma once
/// Shows the document in the window: the setup of the image, and what its effects cost.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Updates everything that follows the document: the camera for the next drag, the look, brightness, undo and so on.
void showDocument(const DesktopParts& parts);
/// Shows what the effects cost, as far as it is known.
void showEffects(const DesktopParts& parts);

}  // namespace pdr::app
