#pragma once
/// Drawings written as text, as the icons have them.

#include <QPainterPath>

namespace pdr::ui {

/// Returns the path of `text`: letters, each followed by its numbers. "M x y" begins a line there and "L x y" goes on,
/// "C" with three points is a cubic Bezier curve, "Z" closes the line, "O x y r" is a circle and "R x y width height" a
/// rectangle with round corners. Ends at the first letter that is none of these.
QPainterPath drawn(const char* text);

}  // namespace pdr::ui
