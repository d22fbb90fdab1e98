#pragma once
/// The length of a path over places [mm].

#include "render/base/result.h"
#include "render/measure/stated.h"

namespace pdr::measure {

/// Returns the length of the straight steps from place to place. Between two places the path may bend: the value knows
/// nothing of that. Fails for fewer than two places, and where a step is shorter than ten standard deviations of its
/// ends: spread would lengthen every step, and the sum with their number.
Result<Stated> pathLength(std::span<const Place> places);

}  // namespace pdr::measure
