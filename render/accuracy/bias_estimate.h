#pragma once
/// How far pictures that are made with a bias end from the truth, from a few of their pixels made both ways with
/// independent random numbers. What the one half of the samples is off, times what the other half is off, is the square
/// of the bias in the mean: noise has no part in it.

#include <optional>
#include <span>
#include <vector>

#include "render/film/moments.h"

namespace pdr {

/// A pixel that shows tissue: its radiance with the bias and without.
struct BothWays {
    HalfMeans biased, exact;
};
/// Neighbours: they are off alike, and chance draws all of them or none.
using BiasTile = std::vector<BothWays>;

/// To 95 % it lies between `low` and `high`.
struct Between {
    double value = 0, low = 0, high = 0;
};

struct MeasuredBias {
    Between brightness;  ///< of the tissue's mean luminance: 0.1 is 10 % too bright
    /// Twice the root mean square of the worst channel [display levels of 255]: 95 % of the tissue is off by less.
    /// `low` is 0 where it may be none; then `high` is the most that would not be seen by now.
    Between levels;
};

/// Tiles with tissue below which nothing is said.
inline constexpr std::size_t kBiasTiles = 16;

/// On a display of that exposure. Tiles are drawn with replacement (Efron 1979), so that the interval holds the noise
/// and the choice of the pixels. Nothing: fewer than kBiasTiles tiles have pixels, or all is black.
std::optional<MeasuredBias> measuredBias(std::span<const BiasTile> tiles, double exposure);

}  // namespace pdr
