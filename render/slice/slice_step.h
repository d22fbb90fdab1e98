#pragma once
/// How far apart slices in any direction lie.

#include "render/volume/volume.h"

namespace pdr {

/// Returns the distance along the unit vector `normal` after which a place lies on other voxels [mm]: where a voxel has
/// the axes s_i, h = 1 / sqrt(sum (n_i / s_i)^2), the radius of the ellipsoid in it. Along an axis of the volume it is
/// the spacing.
inline double sliceStepMm(const VolumeGeometry& geometry, dvec3 normal) {
    return 1 / glm::length(glm::inverse(dmat3(geometry.patientFromIndex)) * normal);
}

}  // namespace pdr
