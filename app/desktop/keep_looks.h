#pragma once
/// Saves, renames, deletes, imports and exports looks for the user.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Offers the user's own looks beside the bundled ones; reports the files that cannot be read.
void offerOwnLooks(const DesktopParts& parts);
/// Saves the look that is shown, with its brightness, as one of the user's own, and chooses it.
void saveLook(const DesktopParts& parts, const QString& name);
void renameLook(const DesktopParts& parts, const QString& from, const QString& to);
void deleteLook(const DesktopParts& parts, const QString& name);
/// Adds the look in `file` to the user's own, and chooses it.
void importLook(const DesktopParts& parts, const QString& file);
/// Writes the look that is shown to `file`, in the format of its file name extension.
void exportLook(const DesktopParts& parts, const QString& file);

}  // namespace pdr::app
