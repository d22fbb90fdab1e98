#include "render/accuracy/bias_text.h"

#include <cmath>
#include <cstdio>

#include "render/film/levels_text.h"

namespace pdr {
namespace {

std::string percentText(double fraction, const char* format) {
    char text[32];
    std::snprintf(text, sizeof text, format, 100 * fraction);
    return text;
}

}  // namespace

std::string measuredText(const MeasuredBias& bias) {
    const auto signedPercent = [](double fraction) { return percentText(fraction, "%+.1f"); };
    const auto& [brightness, levels] = std::pair(bias.brightness, bias.levels);
    const std::string bright = signedPercent(brightness.value) + " % bright (" + signedPercent(brightness.low) +
                               " to " + signedPercent(brightness.high) + "), ";
    if (levels.low <= 0)
        return bright + "95 % of the tissue within ±" + levelsText(levels.high) +
               " levels at most, by now not told from none";
    return bright + "95 % of the tissue within ±" + levelsText(levels.value) + " levels (" + levelsText(levels.low) +
           " to " + levelsText(levels.high) + ")";
}

std::string shareText(double share) {
    return "in at most " + percentText(share, "%.2g") + " % of the tissue";
}

}  // namespace pdr
