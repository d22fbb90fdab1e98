#pragma once
/// Fetches pictures of surroundings.

#include <filesystem>
#include <memory>
#include <string>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/scene_file.h"

namespace pdr::app {

/// The one that the scene file asks for; null where it asks for none. Errors: those of readExr(), and texels that are
/// no light.
Result<std::shared_ptr<const EnvironmentImage>> fetchEnvironment(const SceneFile& file);

/// One that is chosen as light, scaled to mean one. Errors: the same, cancelled(), and that it is black.
Result<std::shared_ptr<const EnvironmentImage>> readSky(const std::filesystem::path& file, const Progress& progress);

}  // namespace pdr::app
