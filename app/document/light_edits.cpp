#include "app/document/light_edits.h"

#include "render/scene/sky_image.h"

namespace pdr::app {

Lighting LightEdits::lighting() const {
    const Look& look = document_.setup().look;
    return {look.rig, look.environment};
}

void LightEdits::setLighting(const Lighting& lighting, bool moving) {
    Look look = document_.setup().look;
    look.rig = lighting.rig;
    look.environment = lighting.environment;
    document_.setLook(look, moving);
}

void LightEdits::setSky(const std::shared_ptr<const EnvironmentImage>& image) {
    setLighting(litBy(lighting(), image), false);
}

void LightEdits::turn(QPointF inHeights, bool moving) {
    setLighting(turned(lighting(), {inHeights.x(), inHeights.y()}, document_.setup().camera), moving);
}

}  // namespace pdr::app
