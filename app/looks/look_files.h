#pragma once
/// Reads and writes looks in files, of this program and of 3D Slicer.

#include <QString>

#include "render/base/result.h"
#include "render/scene/named_look.h"

namespace pdr::app {

/// Returns whether the name ends as that of a look file, ".json" or ".vp", in upper or lower case.
bool isLookFile(const QString& name);

/// Reads a look from ".json" (this program's), ".vp.json" or ".vp" (Slicer's). Slicer's files contain no lights and no
/// brightness: these are taken from `base`, and the name from the file's name. Errors: the file cannot be read, or its
/// content cannot be used.
Result<NamedLook> readLookFile(const QString& path, const NamedLook& base = {});

/// Writes a look in the format of the extension of `path`. The file appears whole or not at all.
Result<void> writeLookFile(const NamedLook& look, const QString& path);

}  // namespace pdr::app
