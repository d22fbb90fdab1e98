#pragma once
/// Which effects a scene calls for, and why. What is not needed is not compiled into the kernel that runs, or not
/// looked at.

#include <cstdint>
#include <vector>

#include "render/base/text.h"

namespace pdr {

struct Scene;

struct Effect {
    Text name;  ///< for the user: "surface reflection"
    bool needed;
    Text reason;                 ///< a phrase: "the gradient factor is 0"
    std::uint32_t features = 0;  ///< bits of kernel/features.h that it compiles in; 0: a number in the kernel decides
    void (*leaveOut)(Scene&) = nullptr;  ///< makes a scene do without it; null where nothing in a scene can
    bool couldBeLeftOut = false;         ///< needed only so that other samples are not taken: it shows nowhere
};

/// Every effect that this version knows, in a fixed order. An effect is off where what the scene says of it cannot
/// show: it needs tissue that the volume holds and a light that shines. The picture with it would be the same, bit by
/// bit; where that is not certain it stays on. `scene` must have passed Scene::check() and have its volume.
std::vector<Effect> needs(const Scene& scene);

/// Whether events look for light also in a direction that they scatter it to, and not only towards the lights: for
/// light from all around, and for lights with a size where scattering is sharper than they are large. It follows from
/// what the scene says and not from what the volume holds: other samples would be another picture.
bool searchesAlongScatter(const Scene& scene);

/// The kernel's features that the needed effects call for.
std::uint32_t neededFeatures(const std::vector<Effect>& effects);

}  // namespace pdr
