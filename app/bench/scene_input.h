#pragma once
/// Scenes for measuring, with their voxels.

#include <string>

#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::bench {

/// The scene file at `path`. Errors: those of the file, and a DICOM folder, which this program cannot read.
Result<Scene> loadScene(const std::string& path);

}  // namespace pdr::bench
