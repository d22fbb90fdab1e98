#pragma once
/// Picks the operation for a type; null for types that it is not made for.

#include "tests/ptx/code/instruction.h"
#include "tests/ptx/text/mnemonic.h"

namespace pdr::ptx {

/// Returns pick.operator()<T>() for the C++ type T of an integer type.
template <class Pick>
Operation ofInteger(Type type, const Pick& pick) {
    switch (type) {
        case Type::u8:
            return pick.template operator()<u8>();
        case Type::s8:
            return pick.template operator()<s8>();
        case Type::u16:
            return pick.template operator()<u16>();
        case Type::s16:
            return pick.template operator()<s16>();
        case Type::u32:
            return pick.template operator()<u32>();
        case Type::s32:
            return pick.template operator()<s32>();
        case Type::u64:
            return pick.template operator()<u64>();
        case Type::s64:
            return pick.template operator()<s64>();
        default:
            return nullptr;
    }
}
template <class Pick>
Operation ofFloat(Type type, const Pick& pick) {
    return type == Type::f32   ? pick.template operator()<f32>()
           : type == Type::f64 ? pick.template operator()<f64>()
                               : nullptr;
}
template <class Pick>
Operation ofNumber(Type type, const Pick& pick) {
    return isFloat(type) ? ofFloat(type, pick) : ofInteger(type, pick);
}
/// Signs do not matter.
template <class Pick>
Operation ofBits(Type type, const Pick& pick) {
    switch (bitsOf(type)) {
        case 8:
            return pick.template operator()<u8>();
        case 16:
            return pick.template operator()<u16>();
        case 32:
            return pick.template operator()<u32>();
        case 64:
            return pick.template operator()<u64>();
        default:
            return nullptr;
    }
}

}  // namespace pdr::ptx
