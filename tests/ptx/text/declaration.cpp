#include "tests/ptx/text/declaration.h"

#include <cctype>
#include <charconv>

#include "tests/ptx/text/statement.h"

namespace pdr::ptx {

namespace {

u32 numberIn(std::string_view text) {
    u32 number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// ".u32": a letter of the kind, then bits.
bool isType(std::string_view word) {
    return word.size() >= 3 && std::string_view("bsuf").find(word[1]) != std::string_view::npos &&
           std::isdigit(static_cast<unsigned char>(word[2])) != 0;
}

}  // namespace

u32 Declaration::placeBehind(u32& used) const {
    const u32 at = (used + align - 1) / align * align;
    used = at + bytes;
    return at;
}

Declaration declarationIn(std::string_view text) {
    u32 align = 0, each = 0;
    while (!text.empty() && text.front() == '.') {
        const std::string_view attribute = takeWord(text);
        if (attribute == ".align")
            align = numberIn(takeWord(text));
        else if (isType(attribute))
            each = numberIn(attribute.substr(2)) / 8;
    }
    const std::size_t bracket = text.find('[');
    const u32 count = bracket == text.npos ? 1 : numberIn(text.substr(bracket + 1));
    return {std::string(trimmed(text.substr(0, bracket))), align > 0 ? align : each, each * count};
}

RegisterSet registerSet(std::string type, std::string_view text) {
    const std::size_t angle = text.find('<');
    return {std::move(type), std::string(text.substr(0, angle)),
            angle == text.npos ? 0 : numberIn(text.substr(angle + 1))};
}

}  // namespace pdr::ptx
