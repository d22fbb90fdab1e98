#pragma once
/// Shows a frame in the window: the image, and how good it is.

#include <memory>

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Clears the image and shows `message` in its place.
void showNoPicture(const DesktopParts& parts, const QString& message);
/// Shows the image of `frame` and how good it is, or the reason why there is none.
void showFrame(const DesktopParts& parts, const std::shared_ptr<const Frame>& frame);
/// Shows how good the image is, in words; also to be called when rendering stops or goes on.
void showStatus(const DesktopParts& parts);
/// Shows the rule by which rendering stops, wherever the window displays it.
void showStop(const DesktopParts& parts, const StopRule& rule);
/// Shows how far the image may be off where the mouse rests.
void showErrorAt(const DesktopParts& parts, QPointF place, const LevelErrorsAt& errors);

}  // namespace pdr::app
