#pragma once
/// Multiple importance sampling (Veach & Guibas 1995): what fraction of a sample counts where another way of sampling
/// could have found it too.

#include "render/base/portable.h"

namespace pdr {

/// Power heuristic for a sample that was found with density `own`, where another way finds it with density `other`.
/// Shares of both add up to 1. `own` of 0 stands for light that no other way can find (a delta direction): 1. Written
/// as a ratio, so that densities up to 1e38 do not overflow.
PDR_HD inline float powerHeuristic(float own, float other) {
    if (!(own > 0))
        return 1;
    const float ratio = other / own;
    return 1 / (1 + ratio * ratio);
}

}  // namespace pdr
