#pragma once
/// Estimates the bias of images from a few of their pixels, which are made both with the bias and exactly, with
/// independent random numbers. The error of one half of the samples times that of the other half is, on average, the
/// square of the bias: noise has no part in it.

#include <optional>
#include <span>
#include <vector>

#include "render/film/display.h"
#include "render/film/moments.h"

namespace pdr {

/// Radiance of a tissue pixel, with the bias and without.
struct BothWays {
    HalfMeans biased, exact;
};
/// Neighbouring pixels. Their biases are alike, and resampling draws all of them or none.
using BiasTile = std::vector<BothWays>;

/// A value, and its 95 % interval from `low` to `high`.
struct Between {
    double value = 0, low = 0, high = 0;
};

struct MeasuredBias {
    Between brightness;  ///< relative bias of the tissue's mean luminance: 0.1 is 10 % too bright
    /// Twice the root mean square bias of the worst channel [display levels of 255]: 95 % of the tissue is off by less.
    /// `low` is 0 if there may be no bias; `high` is then the largest bias that would not be detected yet.
    Between levels;
};

/// Number of tiles with tissue below which there is no estimate.
inline constexpr std::size_t kBiasTiles = 16;

/// Estimates the bias on a display of that tone. Tiles are drawn with replacement (Efron 1979), so that the
/// interval covers the noise and the choice of the pixels. Returns nothing if fewer than kBiasTiles tiles have pixels,
/// or all is black.
std::optional<MeasuredBias> measuredBias(std::span<const BiasTile> tiles, const Tone& tone);

}  // namespace pdr
