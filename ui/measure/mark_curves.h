#pragma once
/// The curves that a mark consists of in a view.

#include <vector>

#include "render/scene/camera.h"
#include "ui/measure/shown_mark.h"

namespace pdr::ui {

/// Parts of equal length into which each curve is divided, so that what lies in front of it can be said of each. The
/// sides of a polygon have fewer, so that all of them together have not many more.
inline constexpr int kCurveParts = 32;

/// A curve in the patient (LPS) [mm]: the ends of its parts, from one end of it to the other.
using MarkCurve = std::vector<dvec3>;

/// Returns the curves of a mark under `camera`. A ball is the circle in which the plane of the camera's target cuts it
/// if the view is a slice, or none; else its outline.
std::vector<MarkCurve> curvesOf(const ShownMark& mark, const Camera& camera, bool slice);

}  // namespace pdr::ui
