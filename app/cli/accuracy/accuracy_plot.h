#pragma once
/// Plot of error against time with logarithmic axes, as an SVG drawing that can be embedded in a page.

#include <QString>
#include <vector>

#include "app/cli/accuracy/accuracy_curve.h"

namespace pdr::app {

/// Draws the curves, each in its colour, with a legend; stated errors are dashed. A dotted line through the first
/// curve's first step falls with the square root of the time, as the error of independent samples does. `floor`: the
/// error of the reference itself [display levels], below which errors cannot be measured, drawn as a grey ground; null
/// if unknown.
QString accuracyPlot(const std::vector<AccuracyCurve>& curves, std::optional<double> floor);

/// Returns the colour of curve i, for legends: "#0072b2". Readers who confuse red and green can tell the colours apart.
const char* curveColour(std::size_t i);

}  // namespace pdr::app
