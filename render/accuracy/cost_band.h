#pragma once
/// A cost as a number with its band, from a few measurements that do not agree.

#include <vector>

#include "render/base/text.h"

namespace pdr {

/// Number of measurements in a band. The median of all measurements that could be made lies between the smallest and
/// the largest of six in 97 of 100 cases (1 - 2 / 2^6), whatever their distribution.
inline constexpr int kBandMeasurements = 6;

/// Smallest, median and largest of some measurements. For differences, in ms, each may be negative.
struct CostBand {
    double low = 0, middle = 0, high = 0;
};

/// Returns the band of one measurement or more, in any order.
CostBand bandOf(std::vector<double> measurements);

enum class CostVerdict {
    costs,       ///< the whole band lies above 0
    saves,       ///< the whole band lies below 0
    withinNoise  ///< neither: the cost is below what the measurement can resolve
};

/// Returns the verdict on a band of differences, with minus without.
CostVerdict verdictOf(const CostBand& difference);

/// Returns the difference as text, never with a negative number: "2.19 (2.02 to 2.30)", "saves 1.20 (1.01 to 1.33)",
/// "< 0.31".
Text costText(const CostBand& difference);

}  // namespace pdr
