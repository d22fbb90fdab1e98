#pragma once
/// Places that were picked in an image, moved to the edge of a structure: along the ray under the pointer, since it is
/// the depth of such a place that depends on the look, not the pixel that shows it.

#include "render/measure/edge.h"

namespace pdr::measure {

/// Returns `picked`, which lies on a ray along the unit vector `alongRay`, moved along it to the edge near it, or as it
/// was if there is none (edgeNear). Its depth is then the edge's, and what was known of it along the ray is gone; the
/// pixel's share lies in the edge. Where the ray grazes the edge, by less than 20 degrees, it is moved across the edge
/// instead, and the spread along the ray stays.
Place onEdge(const Volume& volume, const Place& picked, dvec3 alongRay);

}  // namespace pdr::measure
