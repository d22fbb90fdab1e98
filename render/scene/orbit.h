#pragma once
/// Effects of a drag or the mouse wheel on the camera, as pure functions. Distances are in fractions of the view's
/// height, x to the right, y down.

#include "render/scene/camera.h"

namespace pdr {

inline constexpr double kHalfTurn = 3.14159265358979323846;

/// Rotates `v` about the unit vector `axis` by `angle` [rad], right-handed.
dvec3 turned(dvec3 v, dvec3 axis, double angle);

/// Rotates the eye about the target: one view height = 180 degrees. It passes the poles without a jump.
Camera orbited(const Camera& camera, dvec2 drag);
/// Moves eye and target in the image plane so that the point under the pointer stays under it (at the target's depth).
Camera panned(const Camera& camera, dvec2 drag);
/// Magnifies the view by `factor`; > 1 brings it closer. The target stays; the eye never reaches it.
Camera zoomed(const Camera& camera, double factor);

}  // namespace pdr
