#pragma once
/// The bars of a histogram as it is drawn.

#include <vector>

#include "render/volume/histogram.h"
#include "ui/tissue/plot_view.h"

namespace pdr::ui {

enum class BarScale { linear, logarithmic };

/// Returns the height of the histogram in each pixel column of the view's area, in fractions of the area's height, [0,
/// 1]. Linear: nine in ten of the columns that hold voxels stay below 0.8, and higher ones are cut off at the upper
/// edge, so that the air around the patient does not flatten the rest. Empty for a histogram without voxels.
std::vector<double> histogramBars(const Histogram& histogram, const PlotView& view, BarScale scale);

}  // namespace pdr::ui
