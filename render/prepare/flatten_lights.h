#pragma once
/// Flattening of lights and the environment.

#include "render/prepare/prepared_scene.h"

namespace pdr {

struct Scene;

/// Fills in the lights and the environment. `prepared.environment` must be set if the scene has an environment image.
void flattenLights(PreparedScene& prepared, const Scene& scene);

}  // namespace pdr
