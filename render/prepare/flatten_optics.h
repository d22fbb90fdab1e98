#pragma once
/// The tables of the models without scattering.

#include "render/prepare/prepared_scene.h"

namespace pdr {

struct Scene;

/// Fills `prepared.flat.optics` and what it points into. After the pieces of the transfer function.
void flattenOptics(PreparedScene& prepared, const Scene& scene);

/// For maximumIntensity: the highest HU of each cell, lifted by kMipBias, in place of bounds on the extinction.
Majorants highestHu(const CellRanges& ranges, ivec3 volumeSize, const FlatMask& mask);

/// Share of a radiance by which it may be off so that no channel moves by more than `levels` of 255, whatever the
/// exposure.
double relativeTolerance(double levels);

}  // namespace pdr
