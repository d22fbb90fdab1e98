#pragma once
/// highestOpacity() of kernel/cell_bound.h in O(1) after one table is built: the same number, bit by bit.
/// A sparse table over 1-HU bins: any curve, non-monotone ones and vertical steps included.

#include <vector>

#include "render/kernel/bounds/cell_bound.h"

namespace pdr {

class OpacityMaximum {
  public:
    /// Answers for intervals inside `domain`.
    OpacityMaximum(const FlatTransferFunction& function, HuRange domain);

    /// highestOpacity(function, range)
    float over(HuRange range) const;

  private:
    int first_;
    std::vector<float> points_;  ///< opacity at first_ + i
    /// levels_[l][i]: maximum over bins i .. i + 2^l - 1; bin i is [first_ + i, first_ + i + 1].
    std::vector<std::vector<float>> levels_;
};

}  // namespace pdr
