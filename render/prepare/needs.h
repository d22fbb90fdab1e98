#pragma once
/// The effects that a scene needs, and why. Effects that are not needed are not compiled into the kernel that runs, or
/// not evaluated.

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
    /// Changes a scene so that it does without the effect; null if nothing in a scene can.
    void (*leaveOut)(Scene&) = nullptr;
    /// Changes a scene so that it has the effect, which is off by choice and not for lack of influence; null otherwise.
    void (*bringIn)(Scene&) = nullptr;
    bool couldBeLeftOut = false;  ///< needed only so that the samples do not change: it does not affect the scene
};

/// Returns every effect that this version knows, in a fixed order. An effect is off where it cannot affect the image:
/// it needs tissue that the volume holds and a light that shines. The image with it would be the same, bit by bit;
/// where that is not certain, the effect stays on. `scene` must have passed Scene::check() and have its volume.
std::vector<Effect> needs(const Scene& scene);

/// Returns whether events sample light also along a direction that they scatter it to, and not only towards the lights:
/// for environment light, and for lights with a size where scattering is sharper than the lights are large. The result
/// depends on the scene's settings and not on what the volume holds, since other samples would change the image.
bool searchesAlongScatter(const Scene& scene);

/// Returns the kernel's features that the needed effects require.
std::uint32_t neededFeatures(const std::vector<Effect>& effects);

}  // namespace pdr
