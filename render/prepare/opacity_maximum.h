#pragma once
/// highestOpacity() of kernel/bounds/cell_bound.h in O(1) after a table has been built, with the same result bit by
/// bit. The table is a sparse table over 1-HU bins and works for any curve, including non-monotone ones and vertical
/// steps.

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
    /// Maxima: levels_[l][i] is the maximum over bins i .. i + 2^l - 1; bin i is [first_ + i, first_ + i + 1].
    std::vector<std::vector<float>> levels_;
};

}  // namespace pdr
