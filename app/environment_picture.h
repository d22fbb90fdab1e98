#pragma once
/// Fetches the picture of the surroundings that a scene file asks for.

#include "render/base/result.h"
#include "render/scene/scene_file.h"

namespace pdr::app {

/// Null where the file asks for none. Errors: those of readExr(), and texels that are no light.
Result<std::shared_ptr<const EnvironmentImage>> fetchEnvironment(const SceneFile& file);

}  // namespace pdr::app
