#include "render/accuracy/bias_text.h"

#include <cmath>
#include <cstdio>

#include "render/film/levels_text.h"

namespace pdr {
namespace {

Text percentText(double fraction, const char* format) {
    char text[32];
    std::snprintf(text, sizeof text, format, 100 * fraction);
    return Text::number(text);
}

}  // namespace

Text measuredText(const MeasuredBias& bias) {
    const auto signedPercent = [](double fraction) { return percentText(fraction, "%+.1f"); };
    const auto& [brightness, levels] = std::pair(bias.brightness, bias.levels);
    const Text bright = phrase("%1 % bright (%2 to %3)", signedPercent(brightness.value), signedPercent(brightness.low),
                               signedPercent(brightness.high));
    if (levels.low <= 0)
        return phrase("%1, 95 % of the tissue within ±%2 levels at most, by now not told from none", bright,
                      levelsText(levels.high));
    return phrase("%1, 95 % of the tissue within ±%2 levels (%3 to %4)", bright, levelsText(levels.value),
                  levelsText(levels.low), levelsText(levels.high));
}

Text shareText(double share) {
    return phrase("in at most %1 % of the tissue", percentText(share, "%.2g"));
}

}  // namespace pdr
