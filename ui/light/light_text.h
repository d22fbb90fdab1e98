#pragma once
/// Lights in words.

#include <QString>

#include "render/scene/named_rig.h"
#include "ui/light/light_sphere.h"

namespace pdr::ui {

QString rigName(NamedRig name);
/// What it is good for.
QString rigTip(NamedRig name);
/// "Key: 69° left, 41° up"; behind the patient: "Rim: 27° right, 32° up, from behind".
QString lampText(const SphereLamp& lamp);

}  // namespace pdr::ui
