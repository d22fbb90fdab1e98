#pragma once
/// What the user does with looks beside choosing them.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Offers the user's own looks beside the bundled ones; says which files cannot be read.
void offerOwnLooks(const DesktopParts& parts);
/// The look that is shown, as it is with its brightness, becomes one of the user's own and is chosen.
void saveLook(const DesktopParts& parts, const QString& name);
void renameLook(const DesktopParts& parts, const QString& from, const QString& to);
void deleteLook(const DesktopParts& parts, const QString& name);
/// The look in `file` becomes one of the user's own and is chosen.
void importLook(const DesktopParts& parts, const QString& file);
/// The look that is shown goes to `file`, in the format that its name says.
void exportLook(const DesktopParts& parts, const QString& file);

}  // namespace pdr::app
