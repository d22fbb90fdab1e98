#pragma once
/// The presets that the programs carry inside them.

#include <vector>

#include "render/base/result.h"
#include "render/scene/preset.h"

namespace pdr::app {

/// CT bone (the first, and the default), CT soft tissue, CT angio, CT lung.
Result<std::vector<Preset>> bundledPresets();

}  // namespace pdr::app
