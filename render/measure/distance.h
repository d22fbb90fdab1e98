#pragma once
/// The distance between two places [mm].

#include "render/measure/stated.h"

namespace pdr::measure {

/// Returns the distance below which the two edges at `a` and `b` are blurred into one [mm]: 2.5 times 1 mm, or 2.5
/// times the step of the grid between them, or 1.7 times the wider of the edges. 0 unless both places are at edges.
double thinnestMm(const VolumeGeometry& geometry, const Place& a, const Place& b);

/// Returns the distance between two places of the scan on `geometry`. Spread across the line lengthens it: by that, on
/// average, the value is shorter than what lies between the places. "At most":
///   thin     two edges closer than thinnestMm()
///   spread   closer than three times the spread across the line
Stated distance(const VolumeGeometry& geometry, const Place& a, const Place& b);

}  // namespace pdr::measure
