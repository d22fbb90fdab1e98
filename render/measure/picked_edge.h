#pragma once
/// Places that were picked in an image, moved to the edge of a structure: along the ray under the pointer, since it is
/// the depth of such a place that depends on the look, not the pixel that shows it.

#include "render/measure/edge.h"

namespace pdr::measure {

/// Returns `picked`, which lies on a ray along the unit vector `alongRay`, with how deep looks show a surface added to
/// its spread along the ray: up to 2 mm before or behind the edge, which the spread of the light does not know.
Place offEdge(Place picked, dvec3 alongRay);

/// Returns `picked`, which lies on a ray along the unit vector `alongRay`, moved along it to the edge near it
/// (edgeNear); offEdge() if there is none. Its depth is then the edge's, and what was known of it along the ray is
/// gone; the pixel's share lies in the edge. The grid's share allows for surfaces that curve with a radius of 2 cm.
/// Where the ray grazes the edge, by less than 15 degrees, the place is offEdge() moved across the edge.
Place onEdge(const Volume& volume, const Place& picked, dvec3 alongRay);

}  // namespace pdr::measure
