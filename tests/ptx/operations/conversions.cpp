/// cvt: between numbers.

#include <cmath>
#include <limits>
#include <type_traits>

#include "tests/ptx/operations/by_type.h"
#include "tests/ptx/operations/floats.h"
#include "tests/ptx/operations/lanes.h"
#include "tests/ptx/operations/operations.h"

namespace pdr::ptx {

namespace {

enum class Rounding { nearest, zero, down, up };

template <Rounding Mode, class T>
inline T rounded(T x) {
    if constexpr (Mode == Rounding::nearest)
        return std::nearbyint(x);
    else if constexpr (Mode == Rounding::zero)
        return std::trunc(x);
    else if constexpr (Mode == Rounding::down)
        return std::floor(x);
    else
        return std::ceil(x);
}

/// Out of range: the nearest number that there is; NaN: 0.
template <class D, class A, Rounding Mode>
inline D toInteger(A x) {
    constexpr A kEnd = A(u64(1) << (sizeof(D) * 8 - (std::is_signed_v<D> ? 2 : 1))) * 2;  // one more than the largest
    constexpr A kLow = std::is_signed_v<D> ? -kEnd : A(0);
    const A whole = rounded<Mode>(x);
    const bool inside = whole >= kLow && whole < kEnd;
    const D value = D(inside ? whole : A(0));
    return inside          ? value
           : whole >= kEnd ? std::numeric_limits<D>::max()
           : whole < kLow  ? std::numeric_limits<D>::min()
                           : D(0);
}

/// Returns pick.operator()<Mode>() for the way that rounds to whole numbers; null where none is named.
template <class Pick>
Operation byRounding(const Mnemonic& what, const Pick& pick) {
    if (what.has("rni"))
        return pick.template operator()<Rounding::nearest>();
    if (what.has("rzi"))
        return pick.template operator()<Rounding::zero>();
    if (what.has("rmi"))
        return pick.template operator()<Rounding::down>();
    if (what.has("rpi"))
        return pick.template operator()<Rounding::up>();
    return nullptr;
}

/// cvt.sat: into [0, 1]; NaN gives 0.
template <class A>
inline A saturated(A x) {
    return !(x > 0) ? A(0) : x < 1 ? x : A(1);
}

/// To a whole number of the same type, or into [0, 1].
template <class A>
Operation sameType(const Mnemonic& what) {
    if (what.has("sat"))
        return what.words.size() == 1 ? &unary<A, A, [](A x) { return saturated(x); }>
                                      : static_cast<Operation>(nullptr);
    return byRounding(what, []<Rounding Mode>() -> Operation {
        return &unary<A, A, [](A x) { return canonical(rounded<Mode>(x)); }>;
    });
}

template <class A>
Operation fromFloat(const Mnemonic& what, Type to) {
    return ofInteger(to, [&]<class D>() -> Operation {
        if constexpr (sizeof(D) == 1)
            return nullptr;
        else
            return byRounding(what, []<Rounding Mode>() -> Operation {
                return &unary<D, A, [](A x) { return toInteger<D, A, Mode>(x); }>;
            });
    });
}

template <class A>
Operation fromInteger(const Mnemonic& what, Type to) {
    if (isFloat(to) && !what.has("rn"))
        return nullptr;
    return ofNumber(to, []<class D>() -> Operation { return &unary<D, A, [](A x) { return D(x); }>; });
}

Operation fromFloat32(const Mnemonic& what, Type to) {
    if (to == Type::f64)
        return &unary<f64, f32, [](f32 x) { return f64(x); }>;
    return to == Type::f32 ? sameType<f32>(what) : fromFloat<f32>(what, to);
}

Operation fromFloat64(const Mnemonic& what, Type to) {
    if (to == Type::f32 && what.has("rn"))
        return &unary<f32, f64, [](f64 x) { return canonical(f32(x)); }>;
    return to == Type::f64 ? sameType<f64>(what) : fromFloat<f64>(what, to);
}

}  // namespace

Operation conversion(const Mnemonic& what) {
    if (what.types.size() != 2 || !what.hasOnly({"rn", "rzi", "rni", "rmi", "rpi", "sat"}))
        return nullptr;
    const Type to = what.types[0], from = what.types[1];
    if (what.has("sat") && (to != from || !isFloat(to)))
        return nullptr;
    if (isFloat(from))
        return from == Type::f32 ? fromFloat32(what, to) : fromFloat64(what, to);
    return ofInteger(from, [&]<class A>() -> Operation { return fromInteger<A>(what, to); });
}

}  // namespace pdr::ptx
