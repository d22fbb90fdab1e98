#include "render/base/text.h"

#include <algorithm>
#include <cstdio>

namespace pdr {
namespace {

/// Returns `pattern` with %1 to %9 replaced.
std::string filled(const std::string& pattern, const std::vector<Text>& arguments) {
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool place = pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' &&
                           std::size_t(pattern[i + 1] - '1') < arguments.size();
        if (place)
            text.append(arguments[std::size_t(pattern[++i] - '1')]);
        else
            text.push_back(pattern[i]);
    }
    return text;
}

Text formatted(const char* format, int digits, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, digits, value);
    return Text::number(text);
}

}  // namespace

Text::Text(const char* pattern, std::vector<Text> arguments)
    : std::string(filled(pattern, arguments)),
      kind_(Kind::pattern),
      pattern_(pattern),
      arguments_(std::move(arguments)) {}

Text Text::number(std::string digits) {
    Text text(std::move(digits));
    text.kind_ = Kind::number;
    return text;
}

Text Text::sentence(const Text& phrase) {
    if (phrase.empty())
        return {};
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::string english = phrase;
    if (std::ranges::all_of(english.substr(0, english.find(' ')), isLetter) && english.front() >= 'a')
        english.front() = char(english.front() - 'a' + 'A');
    if (english.back() != '.')
        english.push_back('.');
    Text text(std::move(english));
    text.kind_ = Kind::sentence;
    text.arguments_ = {phrase};
    return text;
}

Text numberOf(double value, int digits) {
    return formatted("%.*g", digits, value);
}

Text fixedNumber(double value, int decimals) {
    return formatted("%.*f", decimals, value);
}

std::string listed(const std::set<std::string, std::less<>>& names) {
    std::string line;
    for (const std::string& name : names)
        line += (line.empty() ? "" : ", ") + name;
    return line;
}

Text joined(const Text& a, const Text& b) {
    return a.empty() ? b : b.empty() ? a : phrase("%1 %2", a, b);
}

}  // namespace pdr
