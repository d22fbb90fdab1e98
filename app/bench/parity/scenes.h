#pragma once
/// Scenes that together use every model and every effect, and that a device must render as the CPU does.

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace pdr::bench {

struct ParityScene {
    std::string name;
    Scene scene;
};

/// Returns small images of a small head phantom.
std::vector<ParityScene> parityScenes();

}  // namespace pdr::bench
