#pragma once
/// highestOpacity() of kernel/bounds/cell_bound.h in O(1) after a table has been built, with the same result bit by
/// bit. The table is a sparse table over 1-HU bins and works for any curve, including non-monotone ones and vertical
/// steps.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "render/kernel/bounds/cell_bound.h"

namespace pdr {

class OpacityMaximum {
  public:
    /// Builds the table for intervals inside `domain`.
    OpacityMaximum(const FlatTransferFunction& function, HuRange domain);

    /// Returns highestOpacity(function, range).
    float over(HuRange range) const;
    /// Returns the HU outside of which over() is that of `before`, a table of the same domain; empty if it is so
    /// everywhere.
    HuRange changedFrom(const OpacityMaximum& before) const;

  private:
    /// Returns the level of the maxima over that many bins: the number of binary digits that it has. No bit_width(),
    /// since all cells of a row are looked up at once.
    static int levelOf(int bins) { return int(std::bit_cast<std::uint32_t>(float(2 * bins + 1)) >> 23) - 127; }

    int first_;
    /// maxima_[i]: opacity at first_ + i; maxima_[(l + 1) * stride_ + i]: maximum over bins i .. i + 2^l - 1; bin i is
    /// [first_ + i, first_ + i + 1].
    std::vector<float> maxima_;
    int stride_;                  ///< number of bins and 1
    HuRange seen_ = kEmptyRange;  ///< HU outside of which all is 0: most cells of a CT need no look at the table
};

inline float OpacityMaximum::over(HuRange range) const {
    const bool isDark = range.highest < seen_.lowest || range.lowest > seen_.highest || range.empty();
    const int from = isDark ? 0 : range.lowest - first_, bins = isDark ? 0 : range.highest - range.lowest;
    const int level = levelOf(bins);
    const float* maxima = maxima_.data() + level * stride_;
    const float most = std::max(maxima[from], maxima[from + bins - ((1 << level) >> 1)]);
    return isDark ? 0 : most;
}

}  // namespace pdr
