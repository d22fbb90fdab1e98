#pragma once
/// Shows messages in the window; the image stays as it is.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Shows an error; the image stays as it is.
void showFailure(const DesktopParts& parts, const Error& error);
/// Reports that the image has been saved in `file`.
void showSaved(const DesktopParts& parts, const QString& file);
/// Warns that the patient may be recognised, if the image shows skin; called after an image has left the window. Once
/// for each scan.
void showWhoCanBeKnown(const DesktopParts& parts);
/// Reports that only the first of several dropped folders is opened.
void showOthersLeftOut(const DesktopParts& parts);
/// Shows sentences about a request that failed while rendering goes on.
void showNotice(const DesktopParts& parts, const QString& sentences);

}  // namespace pdr::app
