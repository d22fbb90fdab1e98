#pragma once
/// What the window shows of the document: the setup of the picture, and what its effects cost.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Everything that follows the document: the camera that the user turns, look, brightness, undo.
void showDocument(const DesktopParts& parts);
/// What the effects cost, as far as it is known.
void showEffects(const DesktopParts& parts);

}  // namespace pdr::app
