#pragma once
/// The places of measurements, from clicks on slices and on the image.

#include "app/presenters/image_pick.h"
#include "render/measure/place.h"
#include "render/slice/slice_plane.h"

namespace pdr::app {

/// Returns whether a place lies in the scan.
bool isInScan(const Volume& volume, dvec3 placeMm);

/// Returns the place of a click on a slice. `toEdge`: at the edge of a structure near it if there is one, in the slice.
measure::Place placeOnSlice(const Volume& volume, const SlicePlane& plane, dvec3 placeMm, bool toEdge);

/// Returns the place of a click on a slice for a measurement that lies in the plane through `onPlaneMm` with the unit
/// normal `normal`: where it meets that plane when seen along the normal. It goes to no edge unless the slice lies
/// along the plane.
measure::Place placeInPlane(const Volume& volume, const SlicePlane& plane, dvec3 placeMm, bool toEdge, dvec3 onPlaneMm,
                            dvec3 normal);

/// Returns the place of a click on the image. `toEdge`: at the edge of a structure near it if there is one, where the
/// ray under the pointer meets it.
measure::Place placeInImage(const Volume& volume, const PickedPlace& picked, bool toEdge);

}  // namespace pdr::app
