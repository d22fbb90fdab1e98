#pragma once
/// A slice as a view: what is painted over images is painted over slices by the same code.

#include "render/scene/camera.h"
#include "render/slice/slice_plane.h"

namespace pdr::ui {

/// Returns the parallel camera that looks along the plane's normal at the plane's middle; its image has the plane's
/// pixels.
Camera cameraFacing(const SlicePlane& plane);

}  // namespace pdr::ui
