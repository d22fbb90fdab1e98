#pragma once
/// Error against time, both logarithmic, as a vector drawing (SVG) that a page can hold.

#include <QString>
#include <vector>

#include "app/cli/accuracy/accuracy_curve.h"

namespace pdr::app {

/// Curves that have steps, each with its colour and its name beside it; what is stated is dashed. A dotted line falls
/// with the root of the time, as independent samples do, through the first curve's first step. `floor`: levels that the
/// reference itself is off, below which nothing can be told; a grey ground.
QString accuracyPlot(const std::vector<AccuracyCurve>& curves, std::optional<double> floor);

/// The colour of curve i, for legends: "#0072b2". Told apart also by those who confuse red and green.
const char* curveColour(std::size_t i);

}  // namespace pdr::app
