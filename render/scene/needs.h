#pragma once
/// Which effects a scene calls for, and why. What is not needed is not compiled into the kernel that runs, or not
/// looked at.

#include <cstdint>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace pdr {

struct Effect {
    std::string name;  ///< for the user: "surface reflection"
    bool needed;
    std::string reason;          ///< a phrase: "the gradient factor is 0"
    std::uint32_t features = 0;  ///< bits of kernel/features.h that it compiles in; 0: a number in the kernel decides
    void (*leaveOut)(Scene&) = nullptr;  ///< makes a scene do without it; null where nothing in a scene can
};

/// Every effect that this version knows, in a fixed order. `scene` must have passed Scene::check(); its volume is not
/// looked at.
std::vector<Effect> needs(const Scene& scene);

/// Whether events look for light also in a direction that they scatter it to, and not only towards the lights: for
/// light from all around, and for lights with a size where scattering is sharper than they are large.
bool searchesAlongScatter(const Scene& scene);

/// The kernel's features that the needed effects call for.
std::uint32_t neededFeatures(const std::vector<Effect>& effects);

}  // namespace pdr
