#pragma once
/// What the window shows of a frame: the picture, and how good it is.

#include <memory>

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// The place of the picture, with a few words in it.
void showNoPicture(const DesktopParts& parts, const QString& message);
/// The picture with what it shows, and how good it is; or why there is none.
void showFrame(const DesktopParts& parts, const std::shared_ptr<const Frame>& frame);
/// How good the picture is, in words; again when the rendering is held or goes on.
void showStatus(const DesktopParts& parts);
/// When rendering holds, wherever that is said.
void showStop(const DesktopParts& parts, const StopRule& rule);
/// How far the picture may be off where the mouse rests.
void showErrorAt(const DesktopParts& parts, QPointF place, const LevelErrorsAt& errors);

}  // namespace pdr::app
