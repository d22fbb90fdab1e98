#pragma once
/// Reads environment images.

#include <filesystem>
#include <memory>
#include <string>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/scene_file.h"

namespace pdr::app {

/// Reads the environment image of a scene file; null if it names none. Errors: those of readExr(), and texels that are
/// not valid radiance.
Result<std::shared_ptr<const EnvironmentImage>> fetchEnvironment(const SceneFile& file);

/// Reads an environment image that the user has chosen as light, and scales it to a mean luminance of 1. Errors:
/// invalid texels, a black image, those of readExr(), cancelled().
Result<std::shared_ptr<const EnvironmentImage>> readSky(const std::filesystem::path& file, const Progress& progress);

}  // namespace pdr::app
