#include "tests/ptx/text/statement.h"

#include <algorithm>

namespace pdr::ptx {

namespace {

constexpr std::string_view kBlank = " \t\r\n";

int opened(char c) {
    const bool opens = c == '[' || c == '{' || c == '(', closes = c == ']' || c == '}' || c == ')';
    return int(opens) - int(closes);
}

}  // namespace

std::string Statement::text() const {
    std::string all = operation;
    for (const std::string& operand : operands)
        all += " " + operand;
    return all;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kBlank);
    return begin == text.npos ? std::string_view{} : text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::string_view takeWord(std::string_view& text) {
    text = trimmed(text);
    const std::size_t end = std::min(text.find_first_of(kBlank), text.size());
    const std::string_view first = text.substr(0, end);
    text = trimmed(text.substr(end));
    return first;
}

std::vector<std::string> cutOperands(std::string_view text) {
    std::vector<std::string> parts;
    const auto keep = [&](std::string_view part) {
        if (!trimmed(part).empty())
            parts.emplace_back(trimmed(part));
    };
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += opened(text[i]);
        if (text[i] != ',' || depth > 0)
            continue;
        keep(text.substr(begin, i - begin));
        begin = i + 1;
    }
    keep(text.substr(begin));
    return parts;
}

std::vector<std::string> elementsOf(const std::string& operand) {
    if (operand.front() != '{')
        return {operand};
    return cutOperands(std::string_view(operand).substr(1, operand.size() - 2));
}

}  // namespace pdr::ptx
