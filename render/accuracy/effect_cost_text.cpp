#include "render/accuracy/effect_cost_text.h"

#include <algorithm>
#include <cmath>

namespace pdr {
namespace {

/// Returns "38 % (36 to 40)". `value` includes its unit.
Text withBand(const Text& value, double low, double high, int decimals) {
    return phrase("%1 (%2 to %3)", value, fixedNumber(low, decimals), fixedNumber(high, decimals));
}

Text percent(double share) {
    return phrase("%1 %", fixedNumber(100 * share, 0));
}

}  // namespace

Text shareText(const CostBand& share) {
    switch (verdictOf(share)) {
        case CostVerdict::costs:
            return withBand(percent(share.middle), 100 * share.low, 100 * share.high, 0);
        case CostVerdict::saves:
            return phrase("saves %1", withBand(percent(-share.middle), -100 * share.high, -100 * share.low, 0));
        case CostVerdict::withinNoise:
            break;
    }
    return phrase("< %1", percent(std::max(std::ceil(100 * share.high), 1.0) / 100));
}

Text levelsText(const Foretold& levels) {
    if (levels.high == 0)
        return Text::number("0");
    const int decimals = levels.high < 1 ? 2 : 1;
    return withBand(fixedNumber(levels.value, decimals), levels.low, levels.high, decimals);
}

Text timeLeftText(const Foretold& ratio) {
    const bool many = ratio.value >= 10;
    const double unit = many ? 1 : 100;
    const Text value = many ? phrase("%1 x", fixedNumber(ratio.value, 0)) : percent(ratio.value);
    return withBand(value, unit * ratio.low, unit * ratio.high, 0);
}

}  // namespace pdr
