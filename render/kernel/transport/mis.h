#pragma once
/// Multiple importance sampling (Veach & Guibas 1995): the weight of a sample that another sampling technique could
/// have found, too.

#include "render/base/lanes.h"

namespace pdr {

/// Returns the power heuristic for a sample that was found with density `own` and that another technique finds with
/// density `other`. The weights of both add up to 1. `own` of 0 stands for light that no other technique can find (a
/// delta direction): 1. It is computed from a ratio, so that densities up to 1e38 do not overflow.
template <class Real>
PDR_HD inline Real powerHeuristic(Real own, Real other) {
    if (!any(own > 0.0f))
        return Real{} + 1.0f;
    const Real ratio = other / own;
    return own > 0.0f ? 1.0f / (1.0f + ratio * ratio) : Real{} + 1.0f;
}

}  // namespace pdr
