#pragma once
/// The presets that the programs carry inside them.

#include <QString>
#include <vector>

#include "render/base/result.h"
#include "render/scene/preset.h"

namespace pdr::app {

/// CT bone (the first, and the default), CT soft tissue, CT angio, CT lung.
Result<std::vector<Preset>> bundledPresets();

/// A preset of the user's own. Errors: the file cannot be read; a field is unknown or out of range.
Result<Preset> readPresetFile(const QString& path);

}  // namespace pdr::app
