#pragma once

#include <algorithm>
#include <vector>

namespace pdr::bench {

/// Returns the median of at least one value; for an even number of values, the upper of the two in the middle.
inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

}  // namespace pdr::bench
