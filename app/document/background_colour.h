#pragma once
/// Converts the colour behind the volume between screen colours and the radiance that the renderer takes.

#include <QColor>

#include "render/base/portable.h"
#include "render/film/display.h"

namespace pdr::app {

/// Returns the screen colour of `radiance`.
QColor shownColour(vec3 radiance, const Display& display);
/// Returns the radiance that the screen shows as `colour`.
vec3 radianceShownAs(const QColor& colour, const Display& display);

}  // namespace pdr::app
