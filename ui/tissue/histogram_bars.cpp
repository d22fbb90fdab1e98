#include "ui/tissue/histogram_bars.h"

#include <algorithm>
#include <cmath>

namespace pdr::ui {
namespace {

constexpr double kMost = 0.9, kMostAt = 0.8;  ///< part of the columns that hold voxels; part of the height

/// Returns the count that is drawn at the height kMostAt.
double reference(std::vector<double> counts) {
    std::erase(counts, 0);
    if (counts.empty())
        return 1;
    const auto most = counts.begin() + std::ptrdiff_t(kMost * double(counts.size() - 1));
    std::nth_element(counts.begin(), most, counts.end());
    return *most;
}

}  // namespace

std::vector<double> histogramBars(const Histogram& histogram, const PlotView& view, BarScale scale) {
    if (histogram.total() == 0)
        return {};
    const double left = view.area().left();
    std::vector<double> bars(std::size_t(view.area().width()));
    for (std::size_t i = 0; i < bars.size(); ++i)
        bars[i] = histogram.count(view.hu(left + double(i)), view.hu(left + double(i + 1)));
    if (scale == BarScale::logarithmic)
        for (double& bar : bars)
            bar = std::log1p(bar);
    const double unit = kMostAt / (scale == BarScale::linear ? reference(bars) : std::ranges::max(bars) + 1e-9);
    for (double& bar : bars)
        bar = std::min(bar * unit, 1.0);
    return bars;
}

}  // namespace pdr::ui
