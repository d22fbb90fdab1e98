#pragma once
/// Conversion between linear light and screen colours (IEC 61966-2-1).

#include <QColor>

#include "render/base/portable.h"

namespace pdr::ui {

/// Returns the screen colour of linear sRGB in [0, 1].
QColor screenColour(vec3 linear);

/// Returns a screen colour as linear sRGB in [0, 1].
vec3 linearColour(const QColor& colour);

}  // namespace pdr::ui
