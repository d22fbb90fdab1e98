#pragma once
/// Whether looks at thin tissue (kernel/walk/thin_walk.h) pay under a curve. Only the curve and the size of a voxel
/// decide, so that all devices choose alike.

#include "render/kernel/flat_scene.h"

namespace pdr {

/// Returns whether the curve shows tissue that is thin enough to be looked at over at least 64 HU, between its
/// outermost nodes.
bool showsThinTissue(const FlatTransferFunction& function, const FlatVolume& volume);

}  // namespace pdr
