#include "app/bench/paper/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pdr::bench::paper {

namespace {

constexpr const char* kNothing = "-";

std::string fixed(double value, int decimals) {
    char text[400];  // the largest double has 309 digits before its point
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string padded(const std::string& text, std::size_t width, bool left) {
    const std::string room(width - text.size(), ' ');
    return left ? text + room : room + text;
}

std::string rule(const std::vector<std::size_t>& widths, std::size_t words) {
    std::string line = "|";
    for (std::size_t column = 0; column < widths.size(); ++column)
        line += std::string(widths[column] + 1, '-') + (column < words ? "-|" : ":|");
    return line + "\n";
}

}  // namespace

std::string TextTable::text() const {
    std::vector<std::size_t> widths(rows_.front().size(), 1);
    for (const auto& row : rows_)
        for (std::size_t column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    std::string text;
    for (std::size_t line = 0; line < rows_.size(); ++line) {
        for (std::size_t column = 0; column < rows_[line].size(); ++column)
            text += "| " + padded(rows_[line][column], widths[column], column < words_) + " ";
        text += "|\n";
        if (line == 0)
            text += rule(widths, words_);
    }
    return text;
}

std::string digits(std::optional<double> value) {
    if (!value || !std::isfinite(*value))
        return kNothing;
    const double size = std::fabs(*value);
    const int before = size > 0 ? int(std::floor(std::log10(size))) + 1 : 1;
    return fixed(*value, std::clamp(4 - before, 0, 9));
}

std::string plain(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string fraction(std::optional<double> value) {
    if (!value || !std::isfinite(*value))
        return kNothing;
    return fixed(*value, *value > 0.99 && *value < 1 ? 4 : 3);
}

std::string percent(std::optional<double> value) {
    return value ? fixed(100 * *value, 0) + " %" : kNothing;
}

std::string milliseconds(std::optional<double> seconds) {
    return seconds ? digits(1e3 * *seconds) : kNothing;
}

}  // namespace pdr::bench::paper
