#pragma once
/// The plane of a patient's symmetry, found by the bones: the plane in which their surface is most nearly its own
/// mirror image.

#include <vector>

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

struct SymmetryPlane {
    dvec3 normal{1, 0, 0};  ///< unit vector; its x is positive: towards the patient's left
    double atMm = 0;        ///< dot(normal, place) of its places
    /// Distances from the mirrored surface of the bones to their surface [mm]: half of them, and nine tenths, are at
    /// most as large.
    double medianMm = 0, mostMm = 0;

    /// Returns the mirror image of a place in patient space.
    dvec3 mirrored(const dvec3& mm) const { return mm - 2 * (glm::dot(normal, mm) - atMm) * normal; }
};

/// Finds the plane, starting from the one across the patient's left-right axis through the middle of the bones, up to
/// 30 mm and 16 degrees away. What has no counterpart, such as a defect, counts no more than 8 mm of misfit. `bones`:
/// cells on the grid of `geometry`, at least one. The same for any number of threads.
SymmetryPlane symmetryOf(const Cells& bones, const CellGrid& grid, const VolumeGeometry& geometry,
                         const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
