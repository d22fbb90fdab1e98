#include "render/accuracy/cost_band.h"

#include <algorithm>
#include <cstdio>

namespace pdr {

namespace {

constexpr double kSmallestShown = 0.01;  ///< ms

std::string text(double milliseconds) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.2f", milliseconds);
    return digits;
}

std::string text(double middle, double low, double high) {
    return text(middle) + " (" + text(low) + " to " + text(high) + ")";
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

std::string costText(const CostBand& difference) {
    switch (verdictOf(difference)) {
        case CostVerdict::costs:
            return text(difference.middle, difference.low, difference.high);
        case CostVerdict::saves:
            return "saves " + text(-difference.middle, -difference.high, -difference.low);
        case CostVerdict::withinNoise:
            break;
    }
    return "< " + text(std::max(difference.high, kSmallestShown));
}

}  // namespace pdr
