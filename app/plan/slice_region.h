#pragma once
/// Regions in the plane of a slice, from the places that were clicked. The voxels that they hold are those of one layer
/// along the plane: their centres lie within half a layer of it, which is half a slice where the plane lies along the
/// scan's slices.

#include <optional>

#include "app/plan/measurement.h"
#include "render/measure/region_statistics.h"

namespace pdr::app {

/// Returns the unit normal of the plane in which the places lie; none if they span no plane. It is the same whichever
/// way round they were clicked, so that of two layers as near to the plane both ways take the same one.
std::optional<dvec3> normalOf(const std::vector<measure::Place>& places);

/// Returns the ellipse about the first place through the second, whose other half axis reaches as far from the first
/// one as the third place. The three must span a plane.
measure::PlaneEllipse ellipseOf(const std::vector<measure::Place>& places);

/// Moves the places of a measurement to where its figure shows them: the third place of an ellipse to the end of its
/// other half axis. Others stay.
void settle(Measurement& measurement);

/// Moves place `index` of a measurement to `to`. The middle of a ball or an ellipse takes the rest along; an ellipse
/// turns with the end of its first half axis.
void movePlace(Measurement& measurement, std::size_t index, const measure::Place& to);

}  // namespace pdr::app
