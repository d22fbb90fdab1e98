#pragma once
/// The exposure change after which the tissue of an image is neither black nor white.

#include "render/film/film.h"

namespace pdr {

/// Returns the stops, in tenths in [-4, 4], that bring the film's tissue into the middle of a display of that exposure:
/// its median between the levels 50 and 150, its 98th percentile not above 245 where that leaves the median there. 0
/// where it is there already, and without tissue.
double stopsFor(const Film& film, double exposure);

}  // namespace pdr
