#pragma once
/// The geometry of slices in their views: which plane a view of some size shows, and how zooming changes that.

#include "app/plan/navigation.h"
#include "render/slice/slice_stack.h"

namespace pdr::app {

/// Returns the plane that a view of `pixels` shows of `slice`, whose pixels are those of a SliceStack. At magnification
/// 1 the whole slice fits the view.
SlicePlane framed(const SlicePlane& slice, const SliceFraming& framing, ivec2 pixels);

/// Returns the framing after a zoom by `factor` during which `placeMm` stays where it is in the view. The magnification
/// stays within its range.
SliceFraming zoomed(const SliceFraming& framing, const SlicePlane& slice, double factor, dvec3 placeMm);

/// Returns the crosshair after `count` steps through the slices of `stack`, from the slice that lies nearest to it; it
/// stops at the ends. It moves from voxel to voxel: in a scan with a tilted gantry along the table or along the slices
/// that were taken, so that it stays in the scan and the other views keep their slices.
dvec3 stepped(const SliceStack& stack, dvec3 crosshairMm, int count);

/// Returns the direction, in pixels, of the line in which the slices of `other` cut `slice`; its larger part is 1.
dvec2 lineOf(const SliceStack& other, const SlicePlane& slice);

/// Returns the crosshair moved within its slice of `stack` by `voxels`, to the right and down. It stays in the scan on
/// `geometry`.
dvec3 nudged(const SliceStack& stack, const VolumeGeometry& geometry, dvec3 crosshairMm, ivec2 voxels);

/// Returns the index of the slice of `stack` that lies nearest to a place.
int nearestSlice(const SliceStack& stack, dvec3 placeMm);

}  // namespace pdr::app
