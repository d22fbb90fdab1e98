#pragma once
/// Upper bounds on the extinction of a fine cell where parts have curves of their own: the largest of the bounds of the
/// curves that are in it, since their weights add up to 1.

#include "render/kernel/bounds/cell_bound.h"

namespace pdr {

/// Calls visit(curve) for each curve that a voxel of a fine cell has. `volume`: size in voxels; `fine`: the grid of
/// fine cells.
template <class Visit>
PDR_HD inline void forCurvesIn(const FlatParts& parts, ivec3 volume, ivec3 fine, ivec3 cell, Visit&& visit) {
    const int only = parts.onlyCurve[cellIndex(cell, fine)];
    if (only != kMixedCell) {
        visit(only);
        return;
    }
    const VoxelSpan x = voxelsOfCell(cell.x, volume.x), y = voxelsOfCell(cell.y, volume.y),
                    z = voxelsOfCell(cell.z, volume.z);
    std::uint64_t seen[4]{};
    for (int k = z.first; k <= z.last; ++k)
        for (int j = y.first; j <= y.last; ++j) {
            const std::uint8_t* row = parts.labels + (std::int64_t(k) * volume.y + j) * volume.x;
            for (int i = x.first; i <= x.last; ++i) {
                const int curve = parts.curveOf[row[i]];
                const std::uint64_t bit = std::uint64_t(1) << (curve & 63);
                if ((seen[curve >> 6] & bit) == 0)
                    visit(curve);
                seen[curve >> 6] |= bit;
            }
        }
}

/// Returns the highest opacity of the whole curve.
PDR_HD inline float highestOpacity(const FlatTransferFunction& curve) {
    float highest = 0;
    for (int i = 0; i < curve.pieceCount; ++i)
        highest = glm::max(highest, curve.pieces[i].opacity);
    return highest;
}

}  // namespace pdr
