#pragma once
/// The appearance of tissue, independent of the patient, the view and the size of the image.

#include "render/film/display.h"
#include "render/scene/light_rig.h"
#include "render/scene/part_styles.h"
#include "render/scene/scene.h"

namespace pdr {

struct Look {
    TransferFunction transferFunction;
    float phaseG = 0;          ///< as Scene::phaseG
    float gradientFactor = 0;  ///< as Scene::gradientFactor
    RayOrigin rayOrigin = RayOrigin::event;
    HuWindow window;
    LightRig rig;
    Environment environment{vec3(0.1f), false};
    Display display;
    Visible visible;
    bool ctDenoised = false;  ///< as Scene::ctDenoised
    PartStyles parts;         ///< how parts are shown, where the scan has them
    bool operator==(const Look&) const = default;
};

/// Checks the ranges of all members; `where` of an error is the field's name.
Result<void> check(const Look& look);

/// Returns `scene` with that look. The lights are placed by the volume of `scene`, which must not be null, and by its
/// camera. Parts are left out: see withParts().
Scene withLook(Scene scene, const Look& look);

}  // namespace pdr
