#pragma once
/// A head under three transfer functions that represent typical media of trackers: walls, veils and fog.

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace pdr::bench {

struct NamedScene {
    std::string name;
    Scene scene;
};

/// Returns the head phantom (256 x 230 x 256 voxels of 0.977 x 1.4 x 0.977 mm) from the front: "bone" is the curve that
/// Exposure Render ships for the Manix head, 31/mm; "skin and bone" is translucent, 1/mm; "soft" has 5/mm at most.
std::vector<NamedScene> headScenes();

}  // namespace pdr::bench
