#include "render/volume/value_unit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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

}  // namespace

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
