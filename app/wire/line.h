#pragma once
/// Lines of UTF-8 without control characters, which programs and terminals can show as they are.

#include <string>
#include <string_view>

namespace pdr::wire {

bool isLine(std::string_view text);
/// `text` as a line of at most `mostBytes`: what is no UTF-8 becomes U+FFFD, what controls a blank, what is too much
/// goes, by whole characters.
std::string lineOf(std::string_view text, std::size_t mostBytes);

}  // namespace pdr::wire
