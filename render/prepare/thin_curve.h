#pragma once
/// Whether looks at tissue (kernel/walk/thin_walk.h, kernel/transport/light_flight.h) pay under a curve. Only the curve
/// and the size of a voxel decide, so that all devices choose alike.

#include "render/kernel/flat_scene.h"

namespace pdr {

/// Returns FlatScene::thinBound [1/mm].
float thinBound(const FlatVolume& volume);

/// Returns whether the curve shows tissue that is thin enough to be looked at over at least 96 HU, between its
/// outermost nodes.
bool showsThinTissue(const FlatTransferFunction& function, const FlatVolume& volume);

/// Returns whether the curve shows the soft tissue of a body, of -150 to 100 HU, and shows it so thinly that light
/// passes it in fewer looks than an exact flight takes steps, one for each voxel.
bool showsSoftTissue(const FlatTransferFunction& function, const FlatVolume& volume);

/// Returns whether the curve's opaque tissue is so dense that exact flights through it take fewer steps than light that
/// flies by looks alone, which takes as many as the tissue is deep.
bool showsDenseTissue(const FlatTransferFunction& function, const FlatVolume& volume);

}  // namespace pdr
