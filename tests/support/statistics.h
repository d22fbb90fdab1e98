#pragma once
/// Statistics of random results: p-values and thresholds. Every test that draws numbers states its false-alarm rate.

#include <cmath>
#include <span>

#include "render/base/significance.h"

namespace pdr::test {

using pdr::allowedZ;
using pdr::chiSquareP;
using pdr::normalP;

/// Returns the p-value of counts whose expectations are equal.
inline double uniformP(std::span<const double> counts) {
    double total = 0, square = 0;
    for (double count : counts)
        total += count;
    const double expected = total / double(counts.size());
    for (double count : counts)
        square += (count - expected) * (count - expected) / expected;
    return chiSquareP(square, double(counts.size()) - 1);
}

/// Mean, and its standard error, of numbers added one by one (Welford).
class Sample {
  public:
    void add(double value) {
        ++count_;
        const double delta = value - mean_;
        mean_ += delta / count_;
        m2_ += delta * (value - mean_);
    }
    double mean() const { return mean_; }
    double variance() const { return m2_ / (count_ - 1); }
    double standardError() const { return std::sqrt(variance() / count_); }
    /// Distance from `truth` in standard errors.
    double z(double truth) const { return (mean_ - truth) / standardError(); }

  private:
    double count_ = 0, mean_ = 0, m2_ = 0;
};

}  // namespace pdr::test
