#pragma once
/// Lights in words.

#include <QString>

#include "render/scene/camera.h"
#include "render/scene/named_rig.h"
#include "ui/light/light_sphere.h"

namespace pdr::ui {

QString rigName(NamedRig name);
/// What it is good for.
QString rigTip(NamedRig name);
/// "Key: from RA, 41° from above": the patient's side as `camera` sees him, and the height in the picture; behind what
/// is seen: "Rim: from LP, 32° from above, from behind".
QString lampText(const SphereLamp& lamp, const Camera& camera);

}  // namespace pdr::ui
