#include "render/volume/value_unit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "render/volume/volume.h"

namespace pdr {
namespace {

constexpr std::string_view kWord = "no-hu";

/// Returns a number that reads back as the same, to the bit.
std::string exact(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// Returns the number that all of `digits` stand for; NaN: none.
double numberIn(std::string_view digits) {
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() ? value : NAN;
}

/// Returns the unit in what follows "no-hu:".
ValueUnit unitFrom(std::string_view name) {
    const std::size_t equals = name.find('=');
    if (equals == std::string_view::npos)
        return ValueUnit::other(std::string(name));
    const std::string_view scale = name.substr(equals + 1);
    const std::size_t at = std::min(scale.find('@'), scale.size() - 1);
    const double step = numberIn(scale.substr(0, at)), zero = numberIn(scale.substr(at + 1));
    if (!std::isfinite(step) || !std::isfinite(zero) || step <= 0)
        return ValueUnit::other({});
    return ValueUnit::other(std::string(name.substr(0, equals)), step, zero);
}

constexpr double kTremble = 1e-6;  // of quotients that are whole numbers

/// Returns how far voxels must move to lie within 16 bits.
double shiftOf(double lowest, double highest) {
    if (highest > INT16_MAX)
        return std::ceil(highest - INT16_MAX - kTremble);
    return lowest < INT16_MIN ? std::floor(lowest - INT16_MIN + kTremble) : 0;
}

/// Returns whether so many steps as 16 bits can count span the range.
bool span(const ValueSteps& steps, const ValueRange& range) {
    return steps.step > 0 && range.highest - range.lowest <= steps.step * (UINT16_MAX + kTremble);
}

ValueUnit countingUnit(const std::string& name, const ValueSteps& steps, const ValueRange& range) {
    const auto voxelOf = [&](double value) { return (value - steps.zero) / steps.step; };
    return ValueUnit::other(name, steps.step,
                            steps.zero + steps.step * shiftOf(voxelOf(range.lowest), voxelOf(range.highest)));
}

}  // namespace

ValueRange ValueRange::none() {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    return {kNone, -kNone};
}

void ValueRange::include(double value) {
    if (!std::isnan(value))
        include(ValueRange{value, value, value == std::floor(value)});
}

void ValueRange::include(const ValueRange& other) {
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
    areWhole = areWhole && other.areWhole;
}

bool ValueRange::isFinite() const {
    return std::isfinite(lowest) && std::isfinite(highest);
}

FittedUnit fittedUnit(const std::string& name, const ValueRange& range, const ValueSteps& steps) {
    constexpr ValueSteps kWhole{1, 0};
    if (range.areWhole && span(kWhole, range))
        return {countingUnit(name, kWhole, range)};
    if (span(steps, range))
        return {countingUnit(name, steps, range)};
    const double all = range.highest - range.lowest, step = all > 0 ? all / UINT16_MAX : 1;
    return {ValueUnit::other(name, step, range.lowest - step * INT16_MIN), all == 0};
}

ValueUnit ValueUnit::other(std::string name, double step, double zero) {
    name.resize(std::min(name.size(), kLongestName));
    std::ranges::replace_if(
        name, [](char each) { return each <= ' ' || each > '~' || each == ',' || each == '='; }, '_');
    return {false, std::move(name), step, zero};
}

int ValueUnit::decimals() const {
    return std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
}

double ValueUnit::roundedValueOf(double voxel) const {
    const double last = std::pow(10.0, decimals());
    return std::round(valueOf(voxel) * last) / last + 0.0;
}

std::string unitWord(const ValueUnit& unit) {
    if (unit.isHu)
        return {};
    std::string word(kWord);
    if (!unit.name.empty() || !unit.isPlain())
        word.append(":").append(unit.name);
    if (!unit.isPlain())
        word.append("=").append(exact(unit.step)).append("@").append(exact(unit.zero));
    return word;
}

ValueUnit unitIn(std::string_view remarks) {
    while (!remarks.empty()) {
        const std::size_t end = remarks.find_first_of(" ,");
        const std::string_view word = remarks.substr(0, end);
        if (word == kWord)
            return ValueUnit::other({});
        if (word.starts_with(kWord) && word[kWord.size()] == ':')
            return unitFrom(word.substr(kWord.size() + 1));
        remarks.remove_prefix(end == std::string_view::npos ? remarks.size() : end + 1);
    }
    return {};
}

ValueUnit unitOf(const Volume& volume) {
    return unitIn(volume.remarks());
}

Text unitText(const ValueUnit& unit) {
    if (unit.isHu)
        return phrase("HU");
    return unit.name.empty() ? phrase("(no unit)") : Text(unit.name);
}

}  // namespace pdr
