#pragma once
/// Edits of the camera's lens, as pure functions. What lies in the sharp plane keeps its place and its size.

#include "render/scene/camera.h"

namespace pdr {

/// Returns `camera` with that projection.
Camera withType(const Camera& camera, Camera::Type type);
/// Returns `camera` with that vertical field of view [degrees]. A perspective camera moves as far away as that needs;
/// others only store the number.
Camera withFieldOfView(const Camera& camera, double degrees);
/// Returns `camera` with its sharp plane `depthMm` > 0 in front of the eye, along the view. A pinhole, which has no
/// sharp plane, gets a lens.
Camera focusedAt(const Camera& camera, double depthMm);

/// The depths between which an image is sharp: distances from the eye along the view [mm].
struct SharpDepths {
    double nearMm, farMm;  ///< farMm: infinite if everything behind is sharp
};
/// Returns the depths between which a point is blurred over less than a 500th of the image's height; 0 to infinity for
/// a pinhole.
SharpDepths sharpDepths(const Camera& camera);

}  // namespace pdr
