#pragma once
/// The voxels that a mask of the body hides, slice by slice on all cores.

#include <cstdint>
#include <span>

#include "render/segment/body_mask.h"
#include "render/segment/checkpoint.h"
#include "render/segment/hidden_table.h"
#include "render/volume/volume.h"

namespace pdr::segment {

/// What lies outside the cells that are shown.
struct Outside {
    std::int64_t seen = 0;             ///< voxels denser than kSeenHu
    std::int16_t highest = INT16_MIN;  ///< highest HU
};

/// Returns what `mask` hides of `volume`.
Outside outsideOf(const BodyMask& mask, const Volume& volume, const Checkpoint& checkpoint);

/// Returns a copy of the voxels with air in place of what `mask` hides.
Voxels hiddenCopy(const BodyMask& mask, const Volume& volume, const Checkpoint& checkpoint);

/// Replaces what `mask` hides of `voxels` with air, and calls `lost` for the slices that change.
void hideIn(std::span<std::int16_t> voxels, const BodyMask& mask, const SliceLoss& lost, const Checkpoint& checkpoint);

}  // namespace pdr::segment
