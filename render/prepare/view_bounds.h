#pragma once
/// Between which depths a camera can meet tissue, per block of pixels: rays start where the first occupied cell of
/// their block begins, and pixels that can meet nothing cost nothing. An accelerator: it never changes the picture.

#include <vector>

#include "render/kernel/flat_scene.h"

namespace pdr {

/// Depth intervals (near, far) [mm along the view] for blocks of kViewBlock x kViewBlock pixels, row by row. Needs the
/// volume, majorants and camera of `scene`. Where tissue reaches the camera's plane every block gets (0, infinity).
std::vector<vec2> viewDepths(const FlatScene& scene);

}  // namespace pdr
