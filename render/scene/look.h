#pragma once
/// How tissue looks, whoever's it is: independent of the patient, the view and the size of the picture.

#include "render/film/display.h"
#include "render/scene/light_rig.h"
#include "render/scene/scene.h"

namespace pdr {

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

}  // namespace pdr
