#include "render/scene/image_setup.h"

#include <cmath>
#include <utility>

#include "render/scene/field_check.h"
#include "render/scene/fields/look_fields.h"

namespace pdr {

Result<void> check(const ImageSetup& setup) {
    if (auto ok = FieldCheck::check(setup); !ok)
        return ok;
    if (auto ok = check(setup.look); !ok)
        return below("look", ok.error());
    if (auto ok = setup.camera.check(); !ok)
        return ok;
    if (auto ok = setup.clip.check(); !ok)
        return below("clip", ok.error());
    return {};
}

std::string lookTitle(const ImageSetup& setup) {
    return setup.lookChanged ? setup.lookName + std::string(kChangedLook) : setup.lookName;
}

Scene sceneOf(const ImageSetup& setup, std::shared_ptr<const Volume> volume, ivec2 film,
              std::shared_ptr<const LabelMap> map) {
    Scene scene;
    scene.volume = std::move(volume);
    scene.camera = setup.camera;
    scene.background = setup.background;
    scene.clip = setup.clip;
    scene.model = setup.model;
    scene.estimator = setup.estimator;
    scene.schedule = setup.schedule;
    scene.film = film;
    scene.lookName = lookTitle(setup);
    return withParts(withLook(std::move(scene), setup.look), std::move(map), setup.look.parts);
}

std::optional<ImageSetup> setupOf(const Scene& scene, ImageSetup setup) {
    if (!scene.parts.map)
        setup.look.transferFunction = scene.transferFunction;
    setup.look.phaseG = scene.phaseG;
    setup.look.gradientFactor = scene.gradientFactor;
    setup.look.rayOrigin = scene.rayOrigin;
    setup.look.environment = scene.environment;
    setup.look.visible = scene.visible;
    setup.look.ctDenoised = scene.ctDenoised;
    if (scene.lights.empty())
        for (RigPanel& panel : setup.look.rig.panels)
            panel.radiance = 0;
    setup.camera = scene.camera;
    setup.background = scene.background;
    setup.clip = scene.clip;
    setup.model = scene.model;
    Scene made = sceneOf(setup, scene.volume, scene.film, scene.parts.map);
    made.revision = scene.revision;
    made.mask = scene.mask;
    return made == scene ? std::optional(std::move(setup)) : std::nullopt;
}

Display displayOf(const ImageSetup& setup) {
    Display display = setup.look.display;
    display.exposure *= float(std::exp2(-setup.stops));
    return display;
}

}  // namespace pdr
