#include "render/accuracy/cost_band.h"

#include <algorithm>

namespace pdr {

namespace {

constexpr double kSmallestShown = 0.01;  ///< ms

Text text(double middle, double low, double high) {
    return phrase("%1 (%2 to %3)", fixedNumber(middle, 2), fixedNumber(low, 2), fixedNumber(high, 2));
}

}  // namespace

CostBand bandOf(std::vector<double> measurements) {
    std::ranges::sort(measurements);
    const std::size_t half = measurements.size() / 2;
    const double middle =
        measurements.size() % 2 == 1 ? measurements[half] : 0.5 * (measurements[half - 1] + measurements[half]);
    return {measurements.front(), middle, measurements.back()};
}

CostVerdict verdictOf(const CostBand& difference) {
    if (difference.low > 0)
        return CostVerdict::costs;
    return difference.high < 0 ? CostVerdict::saves : CostVerdict::withinNoise;
}

Text costText(const CostBand& difference) {
    switch (verdictOf(difference)) {
        case CostVerdict::costs:
            return text(difference.middle, difference.low, difference.high);
        case CostVerdict::saves:
            return phrase("saves %1", text(-difference.middle, -difference.high, -difference.low));
        case CostVerdict::withinNoise:
            break;
    }
    return phrase("< %1", fixedNumber(std::max(difference.high, kSmallestShown), 2));
}

}  // namespace pdr
