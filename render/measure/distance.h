#pragma once
/// The distance between two places [mm].

#include "render/measure/stated.h"

namespace pdr::measure {

/// Returns the distance between two places of the scan on `geometry`. Spread across the line lengthens it: by that, on
/// average, the value is shorter than what lies between the places. "At most":
///   thin     both places are at edges, and closer than resolvedMm(), or than twice that if one of them is at a thin
///            edge; farther apart, half of that edge's blur is part of the ±
///   spread   closer than three times the spread across the line
Stated distance(const VolumeGeometry& geometry, const Place& a, const Place& b);

}  // namespace pdr::measure
