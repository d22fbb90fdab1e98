#pragma once
/// What something costs, from a few measurements that do not agree: a number with its band.

#include <vector>

#include "render/base/text.h"

namespace pdr {

/// So many measurements make a band. The median of all measurements that could be made lies between the smallest and
/// the largest of six in 97 of 100 cases (1 - 2 / 2^6), however they are distributed.
inline constexpr int kBandMeasurements = 6;

/// Smallest, median and largest of some measurements; of differences, in ms, any may be negative.
struct CostBand {
    double low = 0, middle = 0, high = 0;
};

/// Of one measurement or more, in any order.
CostBand bandOf(std::vector<double> measurements);

enum class CostVerdict {
    costs,       ///< the whole band lies above 0
    saves,       ///< the whole band lies below 0
    withinNoise  ///< neither: it costs less than the measurement can tell
};

/// What a band of differences, with minus without, says.
CostVerdict verdictOf(const CostBand& difference);

/// The same in words, never a negative number: "2.19 (2.02 to 2.30)", "saves 1.20 (1.01 to 1.33)", "< 0.31".
Text costText(const CostBand& difference);

}  // namespace pdr
