#pragma once
/// Multiple importance sampling (Veach & Guibas 1995): the weight of a sample that another sampling technique could
/// have found, too.

#include "render/base/portable.h"

namespace pdr {

/// Returns the power heuristic for a sample that was found with density `own` and that another technique finds with
/// density `other`. The weights of both add up to 1. `own` of 0 stands for light that no other technique can find (a
/// delta direction): 1. It is computed from a ratio, so that densities up to 1e38 do not overflow.
PDR_HD inline float powerHeuristic(float own, float other) {
    if (!(own > 0))
        return 1;
    const float ratio = other / own;
    return 1 / (1 + ratio * ratio);
}

}  // namespace pdr
