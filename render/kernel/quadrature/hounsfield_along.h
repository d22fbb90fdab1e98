#pragma once
/// The HU along a straight way through one cell between eight voxel centres: trilinear interpolation along a line is a
/// cubic polynomial, exactly.

#include "render/kernel/flat_scene.h"
#include "render/kernel/quadrature/cubic.h"

namespace pdr {

/// HU at the corners of a cell between voxel centres: [z][y] and along x.
template <class Real>
struct CellCorners {
    Real first[2][2], second[2][2];
};

/// The cell whose lowest corner is voxel (i, j, k), inside [0, lastCorner].
PDR_HD inline CellCorners<float> cornersOf(const FlatVolume& volume, int i, int j, int k) {
    const std::int16_t* v = volume.voxels + k * volume.stepZ + j * volume.stepY + i;
    CellCorners<float> corners;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y) {
            const std::int16_t* row = v + z * volume.stepZ + y * volume.stepY;
            corners.first[z][y] = row[0];
            corners.second[z][y] = row[volume.stepX];
        }
    return corners;
}

#if !defined(__CUDACC__)

/// The same in step. For volumes of at least two voxels along x and fewer than 2^31 in all: neighbours along x are read
/// as one word. Read lane by lane, since the four words of a lane share their address (10 % of a frame's time).
PDR_HD_INLINE CellCorners<FloatLanes> cornersOf(const FlatVolume& volume, IntLanes i, IntLanes j, IntLanes k) {
    const IntLanes index = (k * volume.size.y + j) * volume.size.x + i;
    alignas(IntLanes) std::int32_t at[kLanes], pairs[2][2][kLanes];
    std::memcpy(at, &index, sizeof at);
    for (int lane = 0; lane < kLanes; ++lane)
        for (int z = 0; z < 2; ++z)
            for (int y = 0; y < 2; ++y)
                std::memcpy(&pairs[z][y][lane], volume.voxels + at[lane] + z * volume.stepZ + y * volume.stepY, 4);
    CellCorners<FloatLanes> corners;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y) {
            IntLanes pair;
            std::memcpy(&pair, pairs[z][y], sizeof pair);
            corners.first[z][y] = toFloat((pair << 16) >> 16);
            corners.second[z][y] = toFloat(pair >> 16);
        }
    return corners;
}

#endif

/// From one place in a cell to another, as fractions of the cell in [0, 1]. The coefficients are the blossom of the
/// trilinear form at the two places. Where all corners agree, all coefficients are exactly theirs.
template <class Real>
PDR_HD_INLINE Cubic<Real> hounsfieldAlong(const CellCorners<Real>& corners, const Vec3<Real>& from,
                                          const Vec3<Real>& to) {
    const auto mix = [](Real a, Real b, Real fraction) { return a + (b - a) * fraction; };
    Real x[2][2][2];  // [from or to][z][y]
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y) {
            x[0][z][y] = mix(corners.first[z][y], corners.second[z][y], from.x);
            x[1][z][y] = mix(corners.first[z][y], corners.second[z][y], to.x);
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
