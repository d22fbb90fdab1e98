#pragma once
/// A small volume by a rule in whole numbers, which tests/oracle/volumes.py makes as well. Neighbouring voxels differ
/// by hundreds of HU, and the axes are turned against the patient's, so that no mistake of interpolation or of an axis
/// can hide.

#include <cstdint>
#include <utility>

#include "render/volume/volume.h"

namespace pdr::test {

/// Returns the HU of voxel (i, j, k), in [-1000, 3000].
inline std::int16_t madeHu(std::int64_t i, std::int64_t j, std::int64_t k) {
    return std::int16_t((i * 7919 + j * 104729 + k * 1299709 + i * j * k * 31) % 4001 - 1000);
}

inline Volume madeVolume() {
    const dvec3 spacingMm(0.75, 0.875, 2.125);
    VolumeGeometry geometry{{23, 19, 17}, dmat4(1)};
    geometry.patientFromIndex[0] = dvec4(dvec3(13, 34, -14) / 39.0 * spacingMm.x, 0);
    geometry.patientFromIndex[1] = dvec4(dvec3(-26, 19, 22) / 39.0 * spacingMm.y, 0);
    geometry.patientFromIndex[2] = dvec4(dvec3(26, 2, 29) / 39.0 * spacingMm.z, 0);
    geometry.patientFromIndex[3] = dvec4(-31.5, 12.25, 104.75, 1);
    Voxels voxels;
    for (int k = 0; k < geometry.size.z; ++k)
        for (int j = 0; j < geometry.size.y; ++j)
            for (int i = 0; i < geometry.size.x; ++i)
                voxels.push_back(madeHu(i, j, k));
    return Volume(geometry, std::move(voxels));
}

/// Returns the same voxels on the grid of a tilted gantry: slices drift along their columns.
inline Volume shearedVolume() {
    const Volume made = madeVolume();
    VolumeGeometry geometry = made.geometry();
    geometry.patientFromIndex[2] += dvec4(dvec3(-26, 19, 22) / 39.0 * 0.7, 0);
    return Volume(geometry, Voxels(made.voxels().begin(), made.voxels().end()));
}

}  // namespace pdr::test
