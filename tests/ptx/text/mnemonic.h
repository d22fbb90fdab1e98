#pragma once
/// Names of PTX's operations and types: "cvt.rn.f32.s32".

#include <string>
#include <string_view>
#include <vector>

#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

enum class Type : u8 { none, u8, s8, b8, u16, s16, b16, u32, s32, b32, f32, u64, s64, b64, f64, pred };

/// Returns the type of that name, "u32"; none for what is no type.
Type typeNamed(std::string_view name);
/// Returns its size [bits]; 1 for predicates.
u32 bitsOf(Type type);
bool isFloat(Type type);

/// An operation's name, taken apart: "cvt", {"rn"}, {f32, s32}.
struct Mnemonic {
    std::string base;
    std::vector<std::string> words;  ///< all that are neither the base nor types
    std::vector<Type> types;

    explicit Mnemonic(std::string_view operation);

    bool has(std::string_view word) const;
    /// Returns whether all words are among these: any other would mean another result.
    bool hasOnly(std::initializer_list<std::string_view> known) const;
    /// The last type, which is that of the operands; b32 where no type is named.
    Type type() const { return types.empty() ? Type::b32 : types.back(); }
};

}  // namespace pdr::ptx
