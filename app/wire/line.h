#pragma once
/// Lines of UTF-8 without control characters: safe to display.

#include <string>
#include <string_view>

namespace pdr::wire {

bool isLine(std::string_view text);
/// `text` as a line of at most `mostBytes`: invalid UTF-8 becomes U+FFFD, control characters become blanks, and it is
/// truncated at a character.
std::string lineOf(std::string_view text, std::size_t mostBytes);

}  // namespace pdr::wire
