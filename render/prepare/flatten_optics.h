#pragma once
/// Flattening of the tables for models without scattering.

#include "render/prepare/prepared_scene.h"

namespace pdr {

struct Scene;

/// Fills `prepared.flat.optics` and the table that it points to. Call it after the transfer function has been
/// flattened.
void flattenOptics(PreparedScene& prepared, const Scene& scene);

/// Returns, for maximumIntensity, the highest HU of each cell plus kMipBias in place of bounds on the extinction.
Majorants highestHu(const CellRanges& ranges, ivec3 volumeSize, const FlatMask& mask);

/// Returns the relative error of a radiance that changes no channel by more than `levels` of 255, whatever the
/// exposure.
double relativeTolerance(double levels);

}  // namespace pdr
