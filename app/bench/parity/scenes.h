#pragma once
/// Scenes that between them call for every model and every effect: what a device must render as the CPU does.

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace pdr::bench {

struct ParityScene {
    std::string name;
    Scene scene;
};

/// Small pictures of a small head phantom.
std::vector<ParityScene> parityScenes();

}  // namespace pdr::bench
