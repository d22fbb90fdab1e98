#pragma once
/// Reader of scene files for the benchmark. They must have raw volumes, because this program does not read DICOM.

#include <string>

#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::bench {

/// Returns the scene with its voxels.
Result<Scene> loadScene(const std::string& path);

/// Writes the error to standard error and returns the exit code for it.
int fail(const Error& error);

}  // namespace pdr::bench
