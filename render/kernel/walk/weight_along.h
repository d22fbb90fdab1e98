#pragma once
/// The visibility weight along a straight ray segment through one cell between eight voxel centres.

#include "render/kernel/mask.h"
#include "render/kernel/walk/hounsfield_along.h"

namespace pdr {

/// Returns the weight in the cell whose lowest corner is voxel `corner`, from one position to another, both as
/// fractions of that cell. The cell lies in one cell between nodes of the mask, so that the weight is a cubic as well.
template <class Int, class Real>
PDR_HD_INLINE Cubic<Real> weightAlong(const FlatMask& mask, const Vec3<Int>& corner, const Vec3<Real>& from,
                                      const Vec3<Real>& to) {
    const Vec3<Int> node{corner.x >> mask.shift.x, corner.y >> mask.shift.y, corner.z >> mask.shift.z};
    const VoxelCell<Real> cell = cellAt(mask, node);
    const auto along = [](Int voxel, Int node, int shift, float nodes, Real fraction) {
        return nodes * (toFloat(voxel - (node << shift)) + fraction);
    };
    const auto place = [&](const Vec3<Real>& fraction) {
        return Vec3<Real>{along(corner.x, node.x, mask.shift.x, mask.nodesPerVoxel.x, fraction.x),
                          along(corner.y, node.y, mask.shift.y, mask.nodesPerVoxel.y, fraction.y),
                          along(corner.z, node.z, mask.shift.z, mask.nodesPerVoxel.z, fraction.z)};
    };
    const Cubic<Real> weight = hounsfieldAlong(cell, place(from), place(to));
    return {weight.b0 * kPerWeight, weight.b1 * kPerWeight, weight.b2 * kPerWeight, weight.b3 * kPerWeight};
}

}  // namespace pdr
