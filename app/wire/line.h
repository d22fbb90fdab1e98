#pragma once
/// Lines are UTF-8 texts without control characters, which are safe to display.

#include <string>
#include <string_view>

namespace pdr::wire {

bool isLine(std::string_view text);
/// Returns `text` as a line of at most `mostBytes`: invalid UTF-8 becomes U+FFFD, control characters become blanks, and
/// a long text is truncated between two characters.
std::string lineOf(std::string_view text, std::size_t mostBytes);

}  // namespace pdr::wire
