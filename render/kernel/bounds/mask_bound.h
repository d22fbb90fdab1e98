#pragma once
/// The highest visibility weight in a fine cell, by which the bound on the cell's extinction is multiplied.

#include "render/base/cells.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

/// Returns the highest weight in a fine cell, in [0, kSeen]; 0 for a cell without voxels. `volume`: size in voxels.
PDR_HD inline int highestWeight(const FlatMask& mask, ivec3 volume, ivec3 cell) {
    ivec3 first, last;
    for (int axis = 0; axis < 3; ++axis) {
        const VoxelSpan span = voxelsOfCell(cell[axis], volume[axis]);
        if (span.first > span.last)
            return 0;
        const int shift = mask.shift[axis];
        first[axis] = span.first >> shift;
        last[axis] = glm::min((span.last + (1 << shift) - 1) >> shift, mask.size[axis] - 1);
    }
    int highest = 0;
    for (int k = first.z; k <= last.z; ++k)
        for (int j = first.y; j <= last.y; ++j) {
            const std::int16_t* row = mask.voxels + k * mask.stepZ + j * mask.stepY;
            for (int i = first.x; i <= last.x; ++i)
                highest = glm::max(highest, int(row[i]));
            if (highest == kSeen)  // so it is in most cells, after the first row
                return kSeen;
        }
    return highest;
}

/// Returns a bound on the extinction of a cell whose weights are `weight` at most, from the bound of its tissue. The
/// margin is for the rounding of interpolated weights; where all is visible, the bound stays as it is, bit by bit.
PDR_HD inline float maskedBound(float bound, int weight) {
    constexpr float kRoundingRoom = 1 + 1e-5f;
    return weight == kSeen ? bound : bound * (float(weight) * (kRoundingRoom / kSeen));
}

}  // namespace pdr
