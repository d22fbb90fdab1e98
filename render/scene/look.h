#pragma once
/// How tissue looks, whoever's it is: independent of the patient, the view and the size of the picture.

#include <vector>

#include "render/film/display.h"
#include "render/scene/scene.h"

namespace pdr {

/// Three panels about the volume: key upper left, fill on the other side, rim behind.
struct LightRig {
    enum class Follows {
        camera,  ///< each view is lit alike
        patient  ///< the panels stand where they do for a view from the front
    };
    // Radiance scales; [0, 1e6]. 0: there is no such panel.
    float key = 1;
    float fill = 0.3f;
    float rim = 0.5f;
    Follows follows = Follows::camera;
    bool operator==(const LightRig&) const = default;
};

struct Look {
    TransferFunction transferFunction;
    float phaseG = 0;          ///< as in Scene
    float gradientFactor = 0;  ///< likewise
    HuWindow window;
    LightRig rig;
    Environment environment{vec3(0.1f), false};
    Display display;
    Visible visible;
    bool operator==(const Look&) const = default;
};

/// The ranges of all that it holds, with the field's name in `where`.
Result<void> check(const Look& look);

/// `scene` with that look. What it takes from `scene` is the volume, which must be there, and the camera: they say
/// where the lights stand.
Scene withLook(Scene scene, const Look& look);

/// The panels of `rig` about a volume seen by `camera`.
std::vector<Light> panelsOf(const LightRig& rig, const VolumeGeometry& geometry, const Camera& camera);

}  // namespace pdr
