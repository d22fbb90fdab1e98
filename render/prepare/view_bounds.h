#pragma once
/// The depths between which a camera can meet tissue, for each block of pixels. Rays start where the first occupied
/// cell of their block begins, and pixels that can meet nothing cost nothing. This acceleration never changes the
/// image.

#include <vector>

#include "render/kernel/flat_scene.h"

namespace pdr {

/// Returns depth intervals (near, far) [mm along the view] for blocks of kViewBlock x kViewBlock pixels, row by row.
/// Needs the volume, majorants and camera of `scene`. If tissue reaches the camera's plane, every block gets (0,
/// infinity).
std::vector<vec2> viewDepths(const FlatScene& scene);

/// Returns whether those of `b` are those of `a`, another scene of the same volume: both have bounds above 0 in the
/// same cells, the same view and the same planes that cut. So it is while a hand moves a node or a light.
bool sameViewDepths(const FlatScene& a, const FlatScene& b);

}  // namespace pdr
