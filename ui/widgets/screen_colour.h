#pragma once
/// Colours of light, and those of the screen that look like them (IEC 61966-2-1).

#include <QColor>

#include "render/base/portable.h"

namespace pdr::ui {

/// The screen's colour for linear sRGB in [0, 1].
QColor screenColour(vec3 linear);

/// Linear sRGB in [0, 1].
vec3 linearColour(const QColor& colour);

}  // namespace pdr::ui
