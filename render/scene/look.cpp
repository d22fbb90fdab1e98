#include "render/scene/look.h"

#include <utility>

#include "render/scene/field_check.h"
#include "render/scene/fields/look_fields.h"

namespace pdr {

Result<void> check(const Look& look) {
    if (auto ok = FieldCheck::check(look); !ok)
        return ok;
    if (look.rig.panels.empty() || look.rig.panels.size() > LightRig::kMostPanels)
        return Error{phrase("must be a list of 1 to 64 panels"), "lights.panels", "", ErrorKind::refused};
    if (auto ok = look.transferFunction.check(); !ok)
        return ok;
    if (auto ok = check(look.parts); !ok)
        return ok;
    return check(look.window);
}

Scene withLook(Scene scene, const Look& look) {
    scene.transferFunction = look.transferFunction;
    scene.phaseG = look.phaseG;
    scene.gradientFactor = look.gradientFactor;
    scene.rayOrigin = look.rayOrigin;
    scene.window = look.window;
    scene.lights = panelsOf(look.rig, scene.volume->geometry(), scene.camera);
    scene.environment = look.environment;
    scene.visible = look.visible;
    scene.ctDenoised = look.ctDenoised;
    return scene;
}

}  // namespace pdr
