#pragma once
/// The slices of a volume along its own axes, displayed as in radiology: axial ones as seen from the feet (right: the
/// patient's left, down: posterior), coronal ones from the front (left, feet), sagittal ones from the left (posterior,
/// feet).
///
/// The slices follow the volume also where its axes are turned against the patient's: those along the pair of its axes
/// that lies nearest to the patient's are called axial, and so on. They show voxels as they were measured, without
/// interpolation between slices, and are those that other programs show of the same series. A plane along the patient's
/// own axes is an oblique one like any other (SlicePlane::around).
///
/// Slices that a tilted gantry took do not lie upright above each other (SliceDrift). They are shown as they were
/// taken, each in its own pixels, which drift in the patient from slice to slice. The slices across them lead along the
/// table: each shows the voxels of one row or one column of all slices at their places, upright in the patient, and all
/// of them have their pixels at the same places. Lengths are true in every one.

#include "render/base/result.h"
#include "render/slice/slice_plane.h"
#include "render/volume/volume.h"

namespace pdr {

enum class AnatomicalPlane { axial, coronal, sagittal };
inline constexpr AnatomicalPlane kAnatomicalPlanes[] = {AnatomicalPlane::axial, AnatomicalPlane::coronal,
                                                        AnatomicalPlane::sagittal};

/// Returns "axial", "coronal" or "sagittal".
const char* planeName(AnatomicalPlane plane);

/// Parallel slices through the centres of the voxels, at least one pixel for each voxel. Where the volume has equal
/// spacings along the slice, a pixel is a voxel; else pixels are as large as the smaller spacing, and voxel centres
/// along that axis are pixel centres. The pixels cover the voxels with their edges, to less than a pixel; of slices
/// across a sheared stack, all voxels of all slices.
class SliceStack {
  public:
    SliceStack(const VolumeGeometry& geometry, AnatomicalPlane plane);

    /// Returns the number of slices, at least 1. They count from the feet (axial), the front (coronal) and the
    /// patient's right (sagittal), whatever the order of the voxels in memory.
    int count() const { return count_; }
    /// Returns slice `index`, in [0, count()).
    SlicePlane slice(int index) const;

    /// Returns the unit vector across the slices, towards the next.
    dvec3 across() const { return across_; }
    /// Returns the way from a voxel to its neighbour in the next slice [mm]. In a sheared stack it is not at right
    /// angles to the slices.
    dvec3 voxelStepMm() const { return voxelStepMm_; }
    /// Returns the coordinate of a place across the slices [mm]: along the unit vector that leads towards the head, the
    /// back or the patient's left. In a volume that is not turned, this is the place's own z, y or x.
    double positionMm(dvec3 mm) const { return glm::dot(mm, across_); }
    /// Returns the slice at that coordinate, which may lie between those of the voxels.
    SlicePlane at(double positionMm) const;
    /// Returns the coordinates of both ends of the voxels: half a slice before the first and behind the last.
    dvec2 rangeMm() const;

  private:
    SlicePlane first_;
    dvec3 stepMm_;  ///< from one slice's pixels to those of the next
    dvec3 voxelStepMm_;
    dvec3 across_;  ///< unit vector across the slices, towards the next
    int count_;
};

}  // namespace pdr
