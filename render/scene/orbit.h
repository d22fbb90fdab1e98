#pragma once
/// What a drag or a wheel does to the camera: pure maths, no mouse. Distances in fractions of the view's height,
/// x to the right, y down.

#include "render/scene/camera.h"

namespace pdr {

inline constexpr double kHalfTurn = 3.14159265358979323846;

/// `v` turned about the unit vector `axis` by `angle` [rad], right-handed.
dvec3 turned(dvec3 v, dvec3 axis, double angle);

/// Turns the eye about the target: one view height = 180 degrees. Over the poles without a jump.
Camera orbited(const Camera& camera, dvec2 drag);
/// Moves eye and target in the image plane so that the point under the pointer stays under it (at the target's depth).
Camera panned(const Camera& camera, dvec2 drag);
/// Brings what is seen closer: `factor` > 1 magnifies. The target stays; the eye never reaches it.
Camera zoomed(const Camera& camera, double factor);

}  // namespace pdr
