#pragma once
/// Scenes whose light is easy or hard to find, for testing forecasts.

#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::bench {

struct PredictionScene {
    std::string name;
    Scene scene;
    float exposure = 0.5f;  ///< exposure of its display
};

/// Returns scenes of a lit head, skin and bone: as it is, through a wide lens, as forward-scattering fog, under a small
/// bright lamp, and with many bounces; and of the same head with the look "CT bone".
Result<std::vector<PredictionScene>> predictionScenes();

}  // namespace pdr::bench
