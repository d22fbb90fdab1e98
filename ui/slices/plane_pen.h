#pragma once
/// How the lines are drawn that show where a slice lies.

#include <QPen>

#include "render/slice/slice_stack.h"

namespace pdr::ui {

/// Returns the pen of a plane's line in other slices and in the image: red, green, yellow. Their dashes differ, too,
/// for those who cannot tell the colours apart.
QPen planePen(AnatomicalPlane plane);

}  // namespace pdr::ui
