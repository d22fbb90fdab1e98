#pragma once
/// Volumes whose slices do not lie upright above each other, as those of a CT with a tilted gantry: the step from slice
/// to slice leads sideways too. Lengths are millimetres.

#include "render/volume/volume.h"

namespace pdr {

/// How each slice of a volume lies above the one before.
struct SliceDrift {
    dvec2 sidewaysMm{0};  ///< along the rows (i) and the columns (j); 0 where slices lie upright
    double gapMm = 0;     ///< between the planes of neighbouring slices; the spacing along k where they lie upright

    bool isUpright() const { return sidewaysMm == dvec2(0); }
    /// Returns the angle between the step and the normal of the slices, [0, 90).
    double degrees() const;
};

/// Returns the drift of the slices of a volume whose rows and columns are at right angles. What rounding leaves of a
/// right angle, up to 1e-5 of the gap, is none.
SliceDrift sliceDrift(const VolumeGeometry& geometry);

/// Returns the spacing as radiologists state it [mm]: between the columns, the rows and the planes of the slices.
dvec3 statedSpacingMm(const VolumeGeometry& geometry);

/// Returns the volume of a voxel [ml], whatever the angles of its edges.
double voxelMl(const VolumeGeometry& geometry);

}  // namespace pdr
