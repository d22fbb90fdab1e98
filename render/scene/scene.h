#pragma once
/// All that decides what a picture converges to, as an immutable value. An edit makes a new Scene with a new revision;
/// results carry the revision that they were made for.

#include <cstdint>
#include <memory>
#include <vector>

#include "render/base/result.h"
#include "render/scene/camera.h"
#include "render/scene/clip.h"
#include "render/scene/light.h"
#include "render/scene/transfer_function.h"
#include "render/volume/volume.h"

namespace pdr {

/// The optical models, from cheap to complete.
enum class Model { absorption, emission, emissionAbsorption, singleScattering, multipleScattering, maximumIntensity };

/// Its word in scene files: "singleScattering".
const char* modelName(Model model);

struct Scene {
    std::shared_ptr<const Volume> volume;  ///< never null in a scene that is rendered
    TransferFunction transferFunction;
    Model model = Model::singleScattering;
    float phaseG = 0;          ///< Henyey-Greenstein mean cosine; (-1, 1)
    float gradientFactor = 0;  ///< how readily an event is a surface reflection; [0, 1e6]; 0 = never
    std::vector<Light> lights;
    Environment environment;
    Camera camera;
    Clip clip;
    ivec2 film{512, 512};    ///< pixels; each in [1, 16384]
    int maxBounces = 1000;   ///< multiple scattering: events on a path, at most; what is cut is counted; [1, 100000]
    std::uint64_t seed = 1;  ///< any
    std::uint64_t revision = 0;  ///< grows with each edit

    /// Every range above, and what cannot be rendered yet, with the field's name in `where`. The volume is not looked
    /// at.
    Result<void> check() const;
};

}  // namespace pdr
