#include "app/light_edits.h"

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

void LightEdits::turn(QPointF inHeights, bool moving) {
    Lighting lighting = this->lighting();
    lighting.rig = turned(lighting.rig, {inHeights.x(), inHeights.y()}, document_.setup().camera);
    setLighting(lighting, moving);
}

}  // namespace pdr::app
