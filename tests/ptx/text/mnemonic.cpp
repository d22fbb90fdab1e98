#include "tests/ptx/text/mnemonic.h"

#include <algorithm>
#include <array>

namespace pdr::ptx {

namespace {

struct NamedType {
    std::string_view name;
    u32 bits;
};
/// In the order of Type.
constexpr std::array<NamedType, 16> kTypes{{{"", 0},
                                            {"u8", 8},
                                            {"s8", 8},
                                            {"b8", 8},
                                            {"u16", 16},
                                            {"s16", 16},
                                            {"b16", 16},
                                            {"u32", 32},
                                            {"s32", 32},
                                            {"b32", 32},
                                            {"f32", 32},
                                            {"u64", 64},
                                            {"s64", 64},
                                            {"b64", 64},
                                            {"f64", 64},
                                            {"pred", 1}}};

}  // namespace

Type typeNamed(std::string_view name) {
    const auto found =
        std::find_if(kTypes.begin() + 1, kTypes.end(), [&](const NamedType& t) { return t.name == name; });
    return found != kTypes.end() ? Type(found - kTypes.begin()) : Type::none;
}

u32 bitsOf(Type type) {
    return kTypes[std::size_t(type)].bits;
}

bool isFloat(Type type) {
    return type == Type::f32 || type == Type::f64;
}

Mnemonic::Mnemonic(std::string_view operation) {
    const std::size_t dot = std::min(operation.find('.'), operation.size());
    base = operation.substr(0, dot);
    for (std::string_view rest = operation.substr(dot); !rest.empty();) {
        rest.remove_prefix(1);
        const std::string_view word = rest.substr(0, rest.find('.'));
        if (const Type type = typeNamed(word); type != Type::none)
            types.push_back(type);
        else
            words.emplace_back(word);
        rest.remove_prefix(word.size());
    }
}

bool Mnemonic::has(std::string_view word) const {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool Mnemonic::hasOnly(std::initializer_list<std::string_view> known) const {
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return std::find(known.begin(), known.end(), word) != known.end();
    });
}

}  // namespace pdr::ptx
