#pragma once
/// Texts that state the size of a bias.

#include "render/accuracy/bias_estimate.h"
#include "render/base/text.h"

namespace pdr {

/// Returns "+9.7 % bright (+9.1 to +10.3), 95 % of the tissue within ±12 levels (10 to 14)"; if there may be no bias,
/// "... within ±0.4 levels at most, by now not told from none".
Text measuredText(const MeasuredBias& bias);
/// Returns "in at most 0.02 % of the tissue".
Text shareText(double share);

}  // namespace pdr
