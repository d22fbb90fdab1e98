#pragma once
/// Scene files for the benchmark: raw volumes only, since this program reads no DICOM.

#include <string>

#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::bench {

/// The scene with its voxels.
Result<Scene> loadScene(const std::string& path);

/// Says what is wrong on standard error; returns the exit code for it.
int fail(const Error& error);

}  // namespace pdr::bench
