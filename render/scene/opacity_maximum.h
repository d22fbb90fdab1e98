#pragma once
/// The exact maximum of an opacity curve over any interval of whole Hounsfield units, in O(1) after one table is built.
/// A sparse table over 1-HU bins: any curve, non-monotone ones and vertical steps included.

#include <vector>

#include "render/scene/transfer_function.h"
#include "render/volume/ranges.h"

namespace pdr {

class OpacityMaximum {
  public:
    /// Answers for intervals inside `domain`.
    OpacityMaximum(const TransferFunction& function, HuRange domain);

    /// The largest opacity that a value in [range.lowest, range.highest] can have, widened by kHuSlack at each end
    /// where the interval is not a single value (interpolation rounds). 0 for an empty range, and where the curve is 0,
    /// but not where it is only rounded to 0.
    float over(HuRange range) const;

    /// HU; interpolation rounds by at most 0.015 between the ends of int16.
    static constexpr float kHuSlack = 1.0f / 64;

  private:
    int first_;
    std::vector<float> points_;  ///< opacity at first_ + i
    /// levels_[l][i]: maximum over bins i .. i + 2^l - 1; bin i is [first_ + i, first_ + i + 1].
    std::vector<std::vector<float>> levels_;
};

}  // namespace pdr
