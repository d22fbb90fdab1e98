#include "ui/tissue/plot_view.h"

#include <algorithm>
#include <cmath>

namespace pdr::ui {

void PlotView::setArea(const QRectF& area) {
    area_ = {area.topLeft(), QSizeF(std::max(area.width(), 1.0), std::max(area.height(), 1.0))};
}

void PlotView::show(double lowHu, double highHu) {
    const double middle = (lowHu + highHu) / 2, half = std::clamp(highHu - lowHu, kNarrowest, kWidest) / 2;
    low_ = middle - half;
    high_ = middle + half;
}

void PlotView::zoom(double x, double factor) {
    const double fixed = hu(x), width = std::clamp((high_ - low_) / factor, kNarrowest, kWidest);
    low_ = fixed - (fixed - low_) / (high_ - low_) * width;
    high_ = low_ + width;
}

void PlotView::pan(double pixels) {
    const double by = -pixels * huPerPixel();
    low_ += by;
    high_ += by;
}

double PlotView::placeStep() const {
    return huPerPixel() > 0.2 ? 1 : std::pow(10, std::floor(std::log10(huPerPixel())));
}

std::vector<double> roundMarks(double low, double high, int most) {
    if (!(high > low) || most < 1)
        return {};
    const double least = (high - low) / most, power = std::pow(10, std::floor(std::log10(least)));
    double step = 10 * power;
    for (const double candidate : {5.0, 2.0, 1.0})
        if (candidate * power >= least)
            step = candidate * power;
    std::vector<double> marks;
    for (double n = std::ceil(low / step); n * step <= high; ++n)
        marks.push_back(n * step);
    return marks;
}

}  // namespace pdr::ui
