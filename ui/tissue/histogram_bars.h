#pragma once
/// A histogram as it is drawn.

#include <vector>

#include "render/volume/histogram.h"
#include "ui/tissue/plot_view.h"

namespace pdr::ui {

enum class BarScale { linear, logarithmic };

/// How high the histogram stands in each pixel column of the view's area, in fractions of the area's height, [0, 1].
/// Linear: nine columns in ten that hold voxels fit below 0.8, and higher ones are cut off at the upper edge, so that
/// the air around the patient does not flatten all else. Empty for a histogram of nothing.
std::vector<double> histogramBars(const Histogram& histogram, const PlotView& view, BarScale scale);

}  // namespace pdr::ui
