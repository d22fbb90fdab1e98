#include "render/measure/measure_text.h"

#include <algorithm>
#include <cmath>

namespace pdr::measure {
namespace {

Text withUnit(const Text& number, Unit unit) {
    switch (unit) {
        case Unit::mm:
            return phrase("%1 mm", number);
        case Unit::degrees:
            return phrase("%1°", number);
        case Unit::mm2:
            return phrase("%1 mm²", number);
        case Unit::hu:
            return phrase("%1 HU", number);
    }
    return {};
}

Text number(double value, int decimals) {
    // No "-0".
    const double unit = std::pow(10.0, -decimals);
    return fixedNumber(std::abs(value) < unit / 2 ? 0 : value, std::max(decimals, 0));
}

/// Returns `value` rounded to the last digit that is stated.
double rounded(double value, int decimals) {
    const double unit = std::pow(10.0, decimals);
    return std::round(value * unit) / unit;
}

Text causeText(Cause cause, const Text& plusMinus) {
    switch (cause) {
        case Cause::grid:
            return phrase("grid ±%1", plusMinus);
        case Cause::edge:
            return phrase("edges ±%1", plusMinus);
        case Cause::hand:
            return phrase("hand ±%1", plusMinus);
        case Cause::light:
            return phrase("depth of light ±%1", plusMinus);
    }
    return {};
}

Text boundText(const Stated& stated, Unit unit) {
    // Rounded away from what it bounds, so that it stays true.
    const double value = stated.value * 10;
    if (stated.bound == Bound::atLeast)
        return phrase("at least %1", withUnit(number(std::floor(value) / 10, 1), unit));
    const Text most = withUnit(number(std::ceil(value) / 10, 1), unit);
    return stated.limit == Limit::thin ? phrase("at most %1: thinner than this scan can tell", most)
                                       : phrase("at most %1", most);
}

}  // namespace

RoundedPlusMinus roundedPlusMinus(double plusMinus, double least) {
    const double wanted = std::max(plusMinus, least);
    // The tolerance keeps what is a round number already.
    const int exponent = int(std::floor(std::log10(wanted) + 1e-9));
    const double leading = wanted / std::pow(10.0, exponent);
    const int decimals = (leading < 2 - 1e-9 && exponent >= 0 ? 1 : 0) - exponent;
    const double unit = std::pow(10.0, -decimals);
    return {std::ceil(wanted / unit - 1e-9) * unit, decimals};
}

Text valueText(const Stated& stated, Unit unit) {
    if (stated.bound != Bound::none)
        return boundText(stated, unit);
    const double plusMinus = stated.plusMinus(), value = stated.value;
    if (plusMinus == 0)
        return withUnit(number(value, 1), unit);
    const RoundedPlusMinus spread = roundedPlusMinus(plusMinus);
    return withUnit(phrase("%1 ± %2", number(rounded(value, spread.decimals), spread.decimals),
                           number(spread.plusMinus, spread.decimals)),
                    unit);
}

Text causesText(const Stated& stated) {
    std::vector<std::pair<double, Cause>> causes;
    for (const Cause cause : {Cause::grid, Cause::edge, Cause::hand, Cause::light})
        if (const double share = stated.share(cause); share > 0)
            causes.emplace_back(share, cause);
    std::ranges::stable_sort(causes, [](const auto& a, const auto& b) { return a.first > b.first; });
    Text list;
    for (const auto& [share, cause] : causes) {
        const RoundedPlusMinus spread = roundedPlusMinus(share);
        const Text one = causeText(cause, number(spread.plusMinus, spread.decimals));
        list = list.empty() ? one : phrase("%1, %2", list, one);
    }
    if (list.empty())
        return phrase("Typed places have no ±.");
    return joined(Text::sentence(list), phrase("Not in it: the scanner's own scale, movement, what was meant."));
}

RegionStatistics inValues(RegionStatistics statistics, const ValueUnit& unit) {
    for (double* voxel : {&statistics.meanHu, &statistics.medianHu, &statistics.lowestHu, &statistics.highestHu,
                          &statistics.percentile5, &statistics.percentile95})
        *voxel = unit.valueOf(*voxel);
    statistics.sdHu *= unit.step;
    if (statistics.meanPlusMinus)
        *statistics.meanPlusMinus *= unit.step;
    return statistics;
}

Text meanText(const RegionStatistics& statistics, const ValueUnit& unit) {
    const Text name = unitText(unit);
    if (!statistics.meanPlusMinus)
        return phrase("%1 %2, too few voxels for a ±", number(statistics.meanHu, unit.decimals()), name);
    const RoundedPlusMinus spread = roundedPlusMinus(*statistics.meanPlusMinus, 0.1 * unit.step);
    return phrase("%1 ± %2 %3", number(rounded(statistics.meanHu, spread.decimals), spread.decimals),
                  number(spread.plusMinus, spread.decimals), name);
}

Text regionText(const RegionStatistics& statistics, const ValueUnit& unit) {
    const auto value = [&](double each) { return number(each, unit.decimals()); };
    Text text = phrase("SD %1 %7, median %2 %7, %3 to %4 %7, %5 voxels, %6 ml.", value(statistics.sdHu),
                       value(statistics.medianHu), value(statistics.lowestHu), value(statistics.highestHu),
                       statistics.count, fixedNumber(statistics.millilitres, 2), unitText(unit));
    if (statistics.padding > 0)
        text = joined(text, phrase("The scanner measured nothing in %1 more.", statistics.padding));
    if (statistics.interpolated > 0)
        text = joined(text, phrase("%1 of the voxels are interpolated across a hole.", statistics.interpolated));
    if (statistics.cut)
        text = joined(text, phrase("The region extends beyond the scan."));
    if (statistics.meanPlusMinus)
        text = joined(
            text, phrase("The ± is that of the noise. Not in it: the scanner's own scale, where the region was put."));
    return text;
}

}  // namespace pdr::measure
