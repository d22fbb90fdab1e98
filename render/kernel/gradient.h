#pragma once
/// The gradient of the HU, from which surfaces are made. It is the gradient of a cubic B-spline whose coefficients are
/// the voxels. The spline smooths equally along all axes of the grid and at every position in a cell, and has no kink
/// where a ray passes from one cell to the next. It is exact where the HU are linear. Borders are clamped. It always
/// reads the voxels, never a texture; the HU themselves stay trilinear (volume_sampling.h). Unser 1999, "Splines: a
/// perfect fit for signal and image processing".

#include <cmath>

#include "render/kernel/flat_scene.h"

namespace pdr {

/// The four voxels around a position along one axis, and their weights there.
struct SplineAxis {
    std::int64_t voxel[4];  ///< offset from the first voxel of the volume
    float share[4];         ///< weights of the values (cubic B-spline); their sum is 1
    /// Weights of the steps between neighbouring voxels (its derivative, quadratic); their sum is 1.
    float rise[3];

    /// Computes the weights at `position` (index space). `step`: distance to the next voxel in the array.
    PDR_HD SplineAxis(float position, float lastIndex, std::int64_t step) {
        const float corner = std::floor(position), t = position - corner, u = 1 - t;
        for (int n = 0; n < 4; ++n)
            voxel[n] = step * int(glm::clamp(corner + float(n - 1), 0.0f, lastIndex));
        rise[0] = 0.5f * u * u;
        rise[2] = 0.5f * t * t;
        rise[1] = 1 - rise[0] - rise[2];
        share[0] = rise[0] * u / 3;
        share[3] = rise[2] * t / 3;
        share[1] = 2.0f / 3 - t * t * (1 - 0.5f * t);
        share[2] = 1 - share[0] - share[1] - share[3];
    }

    PDR_HD float value(const float (&v)[4]) const {
        return share[0] * v[0] + share[1] * v[1] + share[2] * v[2] + share[3] * v[3];
    }

    /// Returns the slope per voxel; exactly 0 where all four values agree.
    PDR_HD float slope(const float (&v)[4]) const {
        return rise[0] * (v[1] - v[0]) + rise[1] * (v[2] - v[1]) + rise[2] * (v[3] - v[2]);
    }
};

/// Returns the gradient at `position` (index space), in local space [1/mm], of the spline whose coefficients are
/// valueAt(offset of a voxel from the first one). Reads 64 of them.
template <class ValueAt>
PDR_HD_INLINE vec3 splineGradient(const FlatVolume& volume, vec3 position, ValueAt&& valueAt) {
    // Compute the spline weights along each axis.
    const SplineAxis x(position.x, volume.lastIndex.x, volume.stepX), y(position.y, volume.lastIndex.y, volume.stepY),
        z(position.z, volume.lastIndex.z, volume.stepZ);
    // Sum the values and slopes of the 4 x 4 rows, slice by slice.
    float values[4], slopesX[4], slopesY[4];  // in the four slices
    for (int k = 0; k < 4; ++k) {
        float rows[4], rowSlopes[4];
        for (int j = 0; j < 4; ++j) {
            const std::int64_t row = z.voxel[k] + y.voxel[j];
            const float line[4] = {valueAt(row + x.voxel[0]), valueAt(row + x.voxel[1]), valueAt(row + x.voxel[2]),
                                   valueAt(row + x.voxel[3])};
            rows[j] = x.value(line);
            rowSlopes[j] = x.slope(line);
        }
        values[k] = y.value(rows);
        slopesX[k] = y.value(rowSlopes);
        slopesY[k] = y.slope(rows);
    }
    // Combine the slices and transform the gradient to local space.
    const vec3 perIndex(z.value(slopesX), z.value(slopesY), z.slope(values));
    return glm::transpose(volume.indexFromLocal) * perIndex;
}

/// Returns the gradient of the HU at `position` (index space) in local space [HU/mm].
PDR_HD inline vec3 hounsfieldGradient(const FlatVolume& volume, vec3 position) {
    return splineGradient(volume, position, [&](std::int64_t voxel) { return float(volume.voxels[voxel]); });
}

}  // namespace pdr
