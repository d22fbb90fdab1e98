#pragma once
/// highestOpacity() of kernel/bounds/cell_bound.h in O(1) after a table has been built, with the same result bit by
/// bit. The table is a sparse table over 1-HU bins and works for any curve, including non-monotone ones and vertical
/// steps.

#include <algorithm>
#include <bit>
#include <vector>

#include "render/kernel/bounds/cell_bound.h"

namespace pdr {

class OpacityMaximum {
  public:
    /// Builds the table for intervals inside `domain`.
    OpacityMaximum(const FlatTransferFunction& function, HuRange domain);

    /// Returns highestOpacity(function, range).
    float over(HuRange range) const;

  private:
    int first_;
    std::vector<float> points_;  ///< opacity at first_ + i
    /// Maxima: maxima_[l * stride_ + i] is the maximum over bins i .. i + 2^l - 1; bin i is [first_ + i, first_ + i +
    /// 1].
    std::vector<float> maxima_;
    std::size_t stride_;          ///< number of bins
    HuRange seen_ = kEmptyRange;  ///< HU outside of which all is 0: most cells of a CT need no look at the table
};

inline float OpacityMaximum::over(HuRange range) const {
    if (range.highest < seen_.lowest || range.lowest > seen_.highest || range.empty())
        return 0;
    const unsigned from = unsigned(int(range.lowest) - first_);
    const unsigned bins = unsigned(int(range.highest) - range.lowest);
    if (bins == 0)
        return points_[from];
    const int level = std::bit_width(bins) - 1;
    const float* maxima = maxima_.data() + std::size_t(level) * stride_;
    return std::max(maxima[from], maxima[from + bins - (1u << level)]);
}

}  // namespace pdr
