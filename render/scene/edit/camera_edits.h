#pragma once
/// What a panel does to the camera's lens: pure maths. What lies in the sharp plane keeps its place and its size.

#include "render/scene/camera.h"

namespace pdr {

/// `camera` with that projection.
Camera withType(const Camera& camera, Camera::Type type);
/// A perspective camera with that vertical field of view [degrees], from as far away as it takes. Others only keep the
/// number.
Camera withFieldOfView(const Camera& camera, double degrees);
/// `camera` with its sharp plane through what lies `depthMm` in front of the eye, along the view; > 0. A pinhole, which
/// has none, gets a lens.
Camera focusedAt(const Camera& camera, double depthMm);

/// From where to where a picture is sharp, distances from the eye along the view [mm].
struct SharpDepths {
    double nearMm, farMm;  ///< far: infinite where all behind it is sharp
};
/// Where a point is blurred over less than a 500th of the picture's height; from 0 to infinity for a pinhole.
SharpDepths sharpDepths(const Camera& camera);

}  // namespace pdr
