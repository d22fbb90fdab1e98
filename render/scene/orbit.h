#pragma once
/// What a drag or a wheel does to the camera: pure maths, no mouse. Distances in fractions of the view's height,
/// x to the right, y down.

#include "render/scene/camera.h"

namespace pdr {

/// Turns the eye about the target: one view height = 180 degrees. Over the poles without a jump.
Camera orbited(const Camera& camera, dvec2 drag);
/// Moves eye and target in the image plane so that the point under the pointer stays under it (at the target's depth).
Camera panned(const Camera& camera, dvec2 drag);
/// Brings what is seen closer: `factor` > 1 magnifies. The target stays; the eye never reaches it.
Camera zoomed(const Camera& camera, double factor);

}  // namespace pdr
