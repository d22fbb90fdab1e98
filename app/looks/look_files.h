#pragma once
/// Looks in files: ours, and those of 3D Slicer.

#include <QString>

#include "render/base/result.h"
#include "render/scene/named_look.h"

namespace pdr::app {

/// Whether the name ends as a look's file does: ".json" or ".vp", in small letters or capitals.
bool isLookFile(const QString& name);

/// A look from ".json" (ours), ".vp.json" or ".vp" (Slicer's). What Slicer's files do not say, lights and brightness,
/// is that of `base`; their look is called as the file. Errors: the file cannot be read; what it holds cannot be used.
Result<NamedLook> readLookFile(const QString& path, const NamedLook& base = {});

/// The other way round, by the ending of `path`. The file appears whole or not at all.
Result<void> writeLookFile(const NamedLook& look, const QString& path);

}  // namespace pdr::app
