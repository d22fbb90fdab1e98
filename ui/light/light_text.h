#pragma once
/// Texts that describe lights.

#include <QString>

#include "render/scene/camera.h"
#include "render/scene/named_rig.h"
#include "ui/light/light_sphere.h"

namespace pdr::ui {

QString rigName(NamedRig name);
/// Returns what the rig is good for.
QString rigTip(NamedRig name);
/// Returns a lamp's direction: "Key: from RA, 41° from above": the patient's side as seen by `camera`, and the
/// elevation in the image. A lamp behind the volume: "Rim: from LP, 32° from above, from behind".
QString lampText(const SphereLamp& lamp, const Camera& camera);

}  // namespace pdr::ui
