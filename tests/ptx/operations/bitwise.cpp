/// and, or, xor, not, shl, shr, popc, clz, bfi, prmt.

#include <bit>
#include <type_traits>

#include "tests/ptx/operations/by_type.h"
#include "tests/ptx/operations/lanes.h"
#include "tests/ptx/operations/operations.h"

namespace pdr::ptx {

namespace {

constexpr auto kAnd = [](auto a, auto b) { return decltype(a)(a & b); };
constexpr auto kOr = [](auto a, auto b) { return decltype(a)(a | b); };
constexpr auto kXor = [](auto a, auto b) { return decltype(a)(a ^ b); };
constexpr auto kNot = [](auto a) { return decltype(a)(~a); };
constexpr auto kShl = [](auto a, u32 b) {
    constexpr u32 kWidth = sizeof(a) * 8;
    return b < kWidth ? decltype(a)(u64(a) << b) : decltype(a)(0);
};
constexpr auto kShr = [](auto a, u32 b) {
    constexpr u32 kWidth = sizeof(a) * 8;
    return decltype(a)(b < kWidth ? a >> b : std::is_signed_v<decltype(a)> ? a >> (kWidth - 1) : decltype(a)(0));
};
constexpr auto kPopc = [](auto a) { return u32(std::popcount(a)); };
constexpr auto kClz = [](auto a) { return u32(std::countl_zero(a)); };
constexpr auto kPrmt = [](u32 a, u32 b, u32 choice) {
    const u64 both = u64(b) << 32 | a;
    u32 result = 0;
    for (int byte = 0; byte < 4; ++byte) {
        const u32 nibble = choice >> (4 * byte) & 0xF;
        const u32 value = u32(both >> (8 * (nibble & 7))) & 0xFF;
        result |= ((nibble & 8) != 0 ? ((value & 0x80) != 0 ? 0xFFu : 0u) : value) << (8 * byte);
    }
    return result;
};

/// bfi: the lowest bits of a, put into b.
template <class T>
void insertBits(Warp& w, const Instruction& i) {
    const auto *a = w.at<T>(i.from[0]), *b = w.at<T>(i.from[1]);
    const auto *place = w.at<u32>(i.from[2]), *length = w.at<u32>(i.from[3]);
    setLanes<T>(w, i.to[0], [&](int l) {
        constexpr u32 kWidth = sizeof(T) * 8;
        const u32 at = place[l] & 0xFF, size = length[l] & 0xFF;
        if (at >= kWidth || size == 0)
            return b[l];
        const T field = size >= kWidth ? ~T(0) : T((T(1) << size) - 1);
        return T((b[l] & ~T(field << at)) | T((a[l] & field) << at));
    });
}

template <auto F>
Operation twoBitFields(Type type) {
    return ofBits(type, []<class T>() -> Operation { return &binary<T, T, T, F>; });
}
/// A number of 32 bits, of as many as the type has.
template <auto F>
Operation countOfBits(Type type) {
    return bitsOf(type) == 32 ? &unary<u32, u32, F> : &unary<u32, u64, F>;
}

Operation shiftedRight(Type type) {
    constexpr auto shift = []<class T>() -> Operation { return &binary<T, T, u32, kShr>; };
    const Operation ofInt = ofInteger(type, shift);
    return ofInt != nullptr ? ofInt : ofBits(type, shift);  // .b32 is shifted as unsigned
}

}  // namespace

Operation bitwise(const Mnemonic& what) {
    const Type type = what.type();
    const std::string& base = what.base;
    if (what.types.size() != 1 || !what.words.empty())
        return nullptr;
    if (base == "and")
        return twoBitFields<kAnd>(type);
    if (base == "or")
        return twoBitFields<kOr>(type);
    if (base == "xor")
        return twoBitFields<kXor>(type);
    if (base == "not")
        return ofBits(type, []<class T>() -> Operation { return &unary<T, T, kNot>; });
    if (base == "shl")
        return ofBits(type, []<class T>() -> Operation { return &binary<T, T, u32, kShl>; });
    if (base == "shr")
        return shiftedRight(type);
    if (base == "popc")
        return countOfBits<kPopc>(type);
    if (base == "clz")
        return countOfBits<kClz>(type);
    if (base == "bfi")
        return bitsOf(type) == 32 ? &insertBits<u32> : &insertBits<u64>;
    if (base == "prmt")
        return &ternary<u32, u32, u32, kPrmt>;
    return nullptr;
}

std::vector<Type> sourceTypes(const Mnemonic& what) {
    const Type type = what.type();
    if (what.base == "shl" || what.base == "shr")
        return {type, Type::u32};
    if (what.base == "bfi")
        return {type, type, Type::u32, Type::u32};
    if (what.base == "mad" && what.has("wide"))
        return {type, type, Type::b64};
    return {type};
}

}  // namespace pdr::ptx
