#pragma once

#include <algorithm>
#include <vector>

namespace pdr::bench {

/// Of one value or more; of an even number the upper one of the two in the middle.
inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

}  // namespace pdr::bench
