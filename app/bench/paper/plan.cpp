#include "app/bench/paper/plan.h"

#include <charconv>

namespace pdr::bench::paper {

std::string text(ivec2 size) {
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

std::optional<ivec2> sizeOf(const std::string& text) {
    ivec2 size(0);
    const char* end = text.data() + text.size();
    const auto [x, badX] = std::from_chars(text.data(), end, size.x);
    if (badX != std::errc() || x == end || *x != 'x')
        return std::nullopt;
    const auto [y, badY] = std::from_chars(x + 1, end, size.y);
    if (badY != std::errc() || y != end || size.x < 1 || size.y < 1)
        return std::nullopt;
    return size;
}

}  // namespace pdr::bench::paper
