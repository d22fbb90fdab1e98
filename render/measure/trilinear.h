#pragma once
/// The scan between its voxels as a linear combination of them: trilinear, clamped at the borders, as the renderer and
/// slices interpolate (kernel/volume_sampling.h), but in double and with the weights, by which noise propagates.

#include "render/volume/volume.h"

namespace pdr::measure {

/// Where a grid lies: its index space and that of the patient.
struct GridPlace {
    ivec3 size;
    dmat4 patientFromIndex, indexFromPatient;

    explicit GridPlace(const VolumeGeometry& geometry)
        : size(geometry.size),
          patientFromIndex(geometry.patientFromIndex),
          indexFromPatient(glm::inverse(geometry.patientFromIndex)) {}

    dvec3 index(dvec3 mm) const { return dvec3(indexFromPatient * dvec4(mm, 1)); }
    dvec3 mm(ivec3 voxel) const { return dvec3(patientFromIndex * dvec4(dvec3(voxel), 1)); }
    /// Returns whether a place lies in the box of all voxels, their extents included.
    bool contains(dvec3 mm) const {
        const dvec3 at = index(mm);
        return glm::all(glm::greaterThanEqual(at, dvec3(-0.5))) && glm::all(glm::lessThanEqual(at, dvec3(size) - 0.5));
    }
    std::size_t offset(ivec3 voxel) const {
        return std::size_t(voxel.x) +
               std::size_t(size.x) * (std::size_t(voxel.y) + std::size_t(size.y) * std::size_t(voxel.z));
    }
};

/// Calls visit(voxel, weight) for the voxels around a position in index space. The weights add up to 1.
template <class Visit>
void eachCorner(ivec3 size, dvec3 position, Visit&& visit) {
    const dvec3 inside = glm::clamp(position, dvec3(0), dvec3(size - 1));
    const ivec3 low(glm::min(glm::floor(inside), glm::max(dvec3(size - 2), dvec3(0))));
    const dvec3 share = inside - dvec3(low);
    for (int corner = 0; corner < 8; ++corner) {
        const ivec3 up(corner & 1, corner >> 1 & 1, corner >> 2);
        const dvec3 weights = glm::mix(1.0 - share, share, glm::greaterThan(up, ivec3(0)));
        if (const double weight = weights.x * weights.y * weights.z; weight > 0)
            visit(low + up, weight);
    }
}

/// Returns the HU at a place; that of the border outside.
inline double huAt(const Volume& volume, const GridPlace& grid, dvec3 mm) {
    double hu = 0;
    eachCorner(grid.size, grid.index(mm),
               [&](ivec3 voxel, double weight) { hu += weight * volume.voxels()[grid.offset(voxel)]; });
    return hu;
}

}  // namespace pdr::measure
