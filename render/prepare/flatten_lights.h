#pragma once
/// The part of flatten that knows lights.

#include "render/prepare/prepared_scene.h"

namespace pdr {

struct Scene;

/// Fills in lights and environment; prepared.environment is there when the scene has a picture.
void flattenLights(PreparedScene& prepared, const Scene& scene);

}  // namespace pdr
