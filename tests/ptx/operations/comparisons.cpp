/// setp: comparisons of numbers, whose results are predicates.

#include <type_traits>

#include "tests/ptx/operations/by_type.h"
#include "tests/ptx/operations/lanes.h"
#include "tests/ptx/operations/operations.h"

namespace pdr::ptx {

namespace {

template <class T, auto F>
void compare(Warp& w, const Instruction& i) {
    const auto *a = w.at<Stored<T>>(i.from[0]), *b = w.at<Stored<T>>(i.from[1]);
    u32 bits = 0;
    for (int l = 0; l < kLanes; ++l)
        bits |= u32(F(T(a[l]), T(b[l]))) << l;
    w.setPredicate(i.to[0], bits);
}

/// Comparisons that are true where a number is NaN end with u.
template <class T>
Operation unordered(const std::string& how) {
    if (how == "equ")
        return &compare<T, [](T a, T b) { return !(a < b) && !(b < a); }>;
    if (how == "neu")
        return &compare<T, [](T a, T b) { return a != b; }>;
    if (how == "ltu")
        return &compare<T, [](T a, T b) { return !(a >= b); }>;
    if (how == "leu")
        return &compare<T, [](T a, T b) { return !(b < a); }>;
    if (how == "gtu")
        return &compare<T, [](T a, T b) { return !(a <= b); }>;
    if (how == "geu")
        return &compare<T, [](T a, T b) { return !(a < b); }>;
    if (how == "num")
        return &compare<T, [](T a, T b) { return a == a && b == b; }>;
    if (how == "nan")
        return &compare<T, [](T a, T b) { return a != a || b != b; }>;
    return nullptr;
}

template <class T>
Operation comparisonOf(const std::string& how) {
    if (how == "eq")
        return &compare<T, [](T a, T b) { return a == b; }>;
    if (how == "ne")
        return &compare<T, [](T a, T b) { return a < b || b < a; }>;
    if (how == "lt" || how == "lo")
        return &compare<T, [](T a, T b) { return a < b; }>;
    if (how == "le" || how == "ls")
        return &compare<T, [](T a, T b) { return a <= b; }>;
    if (how == "gt" || how == "hi")
        return &compare<T, [](T a, T b) { return b < a; }>;
    if (how == "ge" || how == "hs")
        return &compare<T, [](T a, T b) { return a >= b; }>;
    if constexpr (std::is_floating_point_v<T>)
        return unordered<T>(how);
    return nullptr;
}

}  // namespace

Operation comparison(const Mnemonic& what) {
    if (what.words.size() != 1 || what.types.size() != 1)
        return nullptr;
    const auto pick = [&]<class T>() { return comparisonOf<T>(what.words[0]); };
    const Operation ofNumbers = ofNumber(what.type(), pick);
    return ofNumbers != nullptr ? ofNumbers : ofBits(what.type(), pick);
}

}  // namespace pdr::ptx
