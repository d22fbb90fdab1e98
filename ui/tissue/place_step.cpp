#include "ui/tissue/place_step.h"

#include <algorithm>
#include <cmath>

#include "ui/text/value_text.h"

namespace pdr::ui {

double placeStep(const ValueUnit& values, double span) {
    constexpr double kSteps = 1000, kTremble = 1e-9;  // of logarithms that are whole numbers
    return values.isHu ? 1 : std::pow(10, std::floor(std::log10(values.step * span / kSteps) + kTremble));
}

int placeDecimals(const ValueUnit& values, double step) {
    constexpr int kMost = 9;
    return std::clamp(int(std::lround(-std::log10(step))), values.decimals(), kMost);
}

QString placeText(const PlotView& view, const ValueUnit& values, double place) {
    return place == std::round(place) ? valueText(values, place)
                                      : valueText(values, view.rounded(place), view.placeStep());
}

}  // namespace pdr::ui
