#pragma once
/// Selection in proportion to weights, by a table of cumulative sums.

#include "render/kernel/ray.h"

namespace pdr {

/// Returns the index of the interval of ascending `sums` [0 .. count] that holds u * sums[count]. Its width is
/// positive.
PDR_HD inline int intervalOf(const float* sums, int count, float u) {
    const float wanted = u * sums[count];
    int low = 0, high = count - 1;  // the last interval with sums[low] <= wanted
    while (low < high) {
        const int middle = (low + high + 1) / 2;
        if (sums[middle] <= wanted)
            low = middle;
        else
            high = middle - 1;
    }
    while (low > 0 && !(sums[low + 1] > sums[low]))  // only if rounding led past the last interval of positive width
        --low;
    return low;
}

}  // namespace pdr
