#pragma once
/// The HU along a straight ray segment through one cell between eight voxel centres. Trilinear interpolation along a
/// line is exactly a cubic polynomial.

#include "render/kernel/voxel_cell.h"
#include "render/kernel/walk/cubic.h"

namespace pdr {

/// Returns the HU from one position in a cell to another, both as fractions of the cell in [0, 1]. The coefficients are
/// the blossom of the trilinear form at the two positions. Where all corners agree, all coefficients are exactly their
/// value.
template <class Real>
PDR_HD_INLINE Cubic<Real> hounsfieldAlong(const VoxelCell<Real>& cell, const Vec3<Real>& from, const Vec3<Real>& to) {
    const auto mix = [](Real a, Real b, Real fraction) { return a + (b - a) * fraction; };
    Real x[2][2][2];  // [from or to][z][y]
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y) {
            const Real* row = cell.hu + 4 * z + 2 * y;
            x[0][z][y] = mix(row[0], row[1], from.x);
            x[1][z][y] = mix(row[0], row[1], to.x);
        }
    const auto place = [&](int atX, int atY, int atZ) {
        const Real y = atY ? to.y : from.y;
        return mix(mix(x[atX][0][0], x[atX][0][1], y), mix(x[atX][1][0], x[atX][1][1], y), atZ ? to.z : from.z);
    };
    const auto third = [](Real a, Real b, Real c) { return a + ((b - a) + (c - a)) * (1.0f / 3); };
    return {place(0, 0, 0), third(place(1, 0, 0), place(0, 1, 0), place(0, 0, 1)),
            third(place(1, 1, 0), place(1, 0, 1), place(0, 1, 1)), place(1, 1, 1)};
}

}  // namespace pdr
