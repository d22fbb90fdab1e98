#pragma once
/// Messages. What was shown before stays.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// A message. What was shown before stays.
void showFailure(const DesktopParts& parts, const Error& error);
/// That the picture is in that file.
void showSaved(const DesktopParts& parts, const QString& file);
/// After a picture has left the window: that the patient may be known by it, where it shows skin. Once for each scan.
void showWhoCanBeKnown(const DesktopParts& parts);
/// Says that one of several folders that were dropped is opened.
void showOthersLeftOut(const DesktopParts& parts);
/// Sentences about something that did not go as it was asked; the rendering goes on.
void showNotice(const DesktopParts& parts, const QString& sentences);

}  // namespace pdr::app
