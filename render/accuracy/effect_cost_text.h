#pragma once
/// Texts of the figures in the cost table of effects, the same in a window and on a terminal.

#include "render/accuracy/cost_band.h"
#include "render/accuracy/forecast.h"
#include "render/base/text.h"

namespace pdr {

/// Returns a share of an iteration's time, where 1 is all of it: "38 % (36 to 40)", "saves 12 % (9 to 14)", "< 3 %".
Text shareText(const CostBand& share);
/// Returns display levels as text: "25.6 (24.9 to 26.3)", "0".
Text levelsText(const Foretold& levels);
/// Returns a time as a fraction of another, where 1 is as long: "55 % (48 to 63)"; from ten times as long on "12 x (10
/// to 15)".
Text timeLeftText(const Foretold& ratio);

}  // namespace pdr
