#pragma once
/// Volumes computed from formulas, for machines without a CT scan and for tests.

#include <cstdint>

#include "render/volume/volume.h"

namespace pdr {

inline constexpr ivec3 kHeadPhantomSize{256, 230, 256};
inline constexpr dvec3 kHeadPhantomSpacingMm{0.977, 1.4, 0.977};

/// Returns a CT-like head: air, skin, a skull of two tables with diploe between them, brain with ventricles, orbits,
/// nose, air sinuses, teeth, and a round cranial defect on the patient's right front. It is upright in patient space
/// and centred on the origin; drawn for a box of 250 mm and scaled as a whole to the smallest side of the grid's box.
///   size   voxels, each >= 1        spacingMm  each > 0        values  HU, [-1024, 3071]
///   seed   for the noise (nearly normal, 6 HU); equal seeds give equal voxels on one machine, whatever its threads
Volume headPhantom(ivec3 size = kHeadPhantomSize, dvec3 spacingMm = kHeadPhantomSpacingMm, std::uint64_t seed = 1);

}  // namespace pdr
