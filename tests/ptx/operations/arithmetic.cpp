/// add, sub, mul, mad, fma, div, rem, min, max, neg, abs, rcp, sqrt, copysign: rounded to nearest even.

#include <cmath>
#include <type_traits>

#include "tests/ptx/operations/by_type.h"
#include "tests/ptx/operations/floats.h"
#include "tests/ptx/operations/lanes.h"
#include "tests/ptx/operations/operations.h"

namespace pdr::ptx {

namespace {

// Integers wrap around: C++ promises that of unsigned numbers only.
constexpr auto kAdd = [](auto a, auto b) {
    if constexpr (std::is_floating_point_v<decltype(a)>)
        return canonical(a + b);
    else
        return decltype(a)(std::make_unsigned_t<decltype(a)>(a) + std::make_unsigned_t<decltype(a)>(b));
};
constexpr auto kSub = [](auto a, auto b) {
    if constexpr (std::is_floating_point_v<decltype(a)>)
        return canonical(a - b);
    else
        return decltype(a)(std::make_unsigned_t<decltype(a)>(a) - std::make_unsigned_t<decltype(a)>(b));
};
constexpr auto kMul = [](auto a, auto b) {
    if constexpr (std::is_floating_point_v<decltype(a)>)
        return canonical(a * b);
    else
        return decltype(a)(u64(a) * u64(b));
};
constexpr auto kMulHigh = [](auto a, auto b) {
    using T = decltype(a);
    using Wide =
        std::conditional_t<sizeof(T) == 8, std::conditional_t<std::is_signed_v<T>, __int128, unsigned __int128>,
                           std::conditional_t<std::is_signed_v<T>, s64, u64>>;
    return T((Wide(a) * Wide(b)) >> (sizeof(T) * 8));
};
constexpr auto kMad = [](auto a, auto b, auto c) { return decltype(a)(u64(a) * u64(b) + u64(c)); };
constexpr auto kFma = [](auto a, auto b, auto c) { return canonical(std::fma(a, b, c)); };
constexpr auto kDiv = [](auto a, auto b) {
    using T = decltype(a);
    if constexpr (std::is_floating_point_v<T>)
        return canonical(a / b);
    else if constexpr (std::is_signed_v<T>)
        return b == 0 ? T(-1) : b == T(-1) ? T(0 - std::make_unsigned_t<T>(a)) : T(a / b);
    else
        return b == 0 ? T(~T(0)) : T(a / b);
};
constexpr auto kRem = [](auto a, auto b) {
    using T = decltype(a);
    return b == 0 ? a : (std::is_signed_v<T> && b == T(-1)) ? T(0) : T(a % b);
};
constexpr auto kMin = [](auto a, auto b) { return least(a, b); };
constexpr auto kMax = [](auto a, auto b) { return most(a, b); };
constexpr auto kNeg = [](auto a) {
    using T = decltype(a);
    if constexpr (std::is_floating_point_v<T>)
        return -a;
    else
        return T(0 - std::make_unsigned_t<T>(a));
};
constexpr auto kAbs = [](auto a) {
    using T = decltype(a);
    if constexpr (std::is_floating_point_v<T>)
        return std::fabs(a);
    else
        return T(a < 0 ? 0 - std::make_unsigned_t<T>(a) : std::make_unsigned_t<T>(a));
};
constexpr auto kRcp = [](auto a) { return canonical(decltype(a)(1) / a); };
constexpr auto kSqrt = [](auto a) { return canonical(std::sqrt(a)); };
constexpr auto kCopysign = [](auto a, auto b) { return std::copysign(b, a); };  // of the first, to the second

template <auto F>
Operation oneNumber(Type type) {
    return ofNumber(type, []<class T>() -> Operation { return &unary<T, T, F>; });
}
template <auto F>
Operation twoNumbers(Type type) {
    return ofNumber(type, []<class T>() -> Operation { return &binary<T, T, T, F>; });
}
template <auto F>
Operation oneFloat(Type type) {
    return ofFloat(type, []<class T>() -> Operation { return &unary<T, T, F>; });
}
template <auto F>
Operation twoIntegers(Type type) {
    return ofInteger(type, []<class T>() -> Operation { return &binary<T, T, T, F>; });
}

/// mul.wide: the result has twice the bits.
Operation wideProduct(Type type) {
    switch (type) {
        case Type::u16:
            return &binary<u32, u16, u16, [](u16 a, u16 b) { return u32(a) * b; }>;
        case Type::s16:
            return &binary<s32, s16, s16, [](s16 a, s16 b) { return s32(a) * b; }>;
        case Type::u32:
            return &binary<u64, u32, u32, [](u32 a, u32 b) { return u64(a) * b; }>;
        case Type::s32:
            return &binary<s64, s32, s32, [](s32 a, s32 b) { return s64(a) * b; }>;
        default:
            return nullptr;
    }
}

Operation product(const Mnemonic& what) {
    if (what.has("wide"))
        return wideProduct(what.type());
    if (what.has("hi"))
        return twoIntegers<kMulHigh>(what.type());
    return twoNumbers<kMul>(what.type());
}

Operation multiplyAdd(const Mnemonic& what) {
    const Type type = what.type();
    if (what.has("wide"))
        return type == Type::u32   ? &ternary<u64, u32, u64, [](u32 a, u32 b, u64 c) { return u64(a) * b + c; }>
               : type == Type::s32 ? &ternary<u64, s32, u64, [](s32 a, s32 b, u64 c) { return u64(s64(a) * b) + c; }>
                                   : static_cast<Operation>(nullptr);
    if (!what.has("lo"))
        return nullptr;
    return ofBits(type, []<class T>() -> Operation { return &ternary<T, T, T, kMad>; });
}

/// Operations on floats that must say how they round.
Operation roundedFloat(const Mnemonic& what) {
    const Type type = what.type();
    if (what.base == "fma")
        return ofFloat(type, []<class T>() -> Operation { return &ternary<T, T, T, kFma>; });
    if (what.base == "div")
        return twoNumbers<kDiv>(type);
    if (what.base == "rcp")
        return oneFloat<kRcp>(type);
    if (what.base == "sqrt")
        return oneFloat<kSqrt>(type);
    return nullptr;
}

}  // namespace

Operation arithmetic(const Mnemonic& what) {
    const Type type = what.type();
    const std::string& base = what.base;
    if (what.types.size() != 1 || !what.hasOnly({"rn", "lo", "hi", "wide"}))
        return nullptr;
    if (base == "add")
        return twoNumbers<kAdd>(type);
    if (base == "sub")
        return twoNumbers<kSub>(type);
    if (base == "mul")
        return product(what);
    if (base == "mad")
        return multiplyAdd(what);
    if (base == "div" && !isFloat(type))
        return twoIntegers<kDiv>(type);
    if (base == "rem")
        return twoIntegers<kRem>(type);
    if (base == "min")
        return twoNumbers<kMin>(type);
    if (base == "max")
        return twoNumbers<kMax>(type);
    if (base == "neg")
        return oneNumber<kNeg>(type);
    if (base == "abs")
        return oneNumber<kAbs>(type);
    if (base == "copysign")
        return ofFloat(type, []<class T>() -> Operation { return &binary<T, T, T, kCopysign>; });
    return what.has("rn") ? roundedFloat(what) : nullptr;
}

}  // namespace pdr::ptx
