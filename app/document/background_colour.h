#pragma once
/// The colour behind the volume, as the screen shows it and as the renderer takes it.

#include <QColor>

#include "render/base/portable.h"
#include "render/film/display.h"

namespace pdr::app {

/// How radiance is shown.
QColor shownColour(vec3 radiance, const Display& display);
/// The radiance that is shown so.
vec3 radianceShownAs(const QColor& colour, const Display& display);

}  // namespace pdr::app
