#include "render/accuracy/ledger_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pdr {
namespace {

std::string number(double value, int decimals) {
    char digits[64];
    std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
    return digits;
}

/// "38 % (36 to 40)"
std::string withBand(double value, double low, double high, const char* unit, int decimals) {
    return number(value, decimals) + unit + " (" + number(low, decimals) + " to " + number(high, decimals) + ")";
}

}  // namespace

std::string shareText(const CostBand& share) {
    switch (verdictOf(share)) {
        case CostVerdict::costs:
            return withBand(100 * share.middle, 100 * share.low, 100 * share.high, " %", 0);
        case CostVerdict::saves:
            return "saves " + withBand(-100 * share.middle, -100 * share.high, -100 * share.low, " %", 0);
        case CostVerdict::withinNoise:
            break;
    }
    return "< " + number(std::max(std::ceil(100 * share.high), 1.0), 0) + " %";
}

std::string levelsText(const Foretold& levels) {
    if (levels.high == 0)
        return "0";
    const int decimals = levels.high < 1 ? 2 : 1;
    return withBand(levels.value, levels.low, levels.high, "", decimals);
}

std::string timeLeftText(const Foretold& ratio) {
    const bool many = ratio.value >= 10;
    const double unit = many ? 1 : 100;
    return withBand(unit * ratio.value, unit * ratio.low, unit * ratio.high, many ? " x" : " %", 0);
}

}  // namespace pdr
