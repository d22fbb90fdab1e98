#pragma once
/// Operations on the registers of 32 lanes, made of functions of one lane's numbers.

#include <type_traits>

#include "tests/ptx/machine/warp.h"

namespace pdr::ptx {

/// How a number lies in a register file: 16 bits in the lower half of 32, all else as it is.
template <class T>
using Stored = std::conditional_t<sizeof(T) < 4, u32, T>;

template <class T>
constexpr Stored<T> stored(T value) {
    if constexpr (sizeof(T) < 4)
        return std::make_unsigned_t<T>(value);
    else
        return value;
}

/// Sets the register at `slot` to value(lane) in the lanes that take part. value() is asked for all lanes, which
/// compilers make vectors of.
template <class R, class Value>
inline void setLanes(Warp& w, u32 slot, const Value& value) {
    auto* to = w.at<Stored<R>>(slot);
    const u32 mask = w.mask;
    if (mask == kAllLanes) {
#pragma GCC ivdep
        for (int l = 0; l < kLanes; ++l)
            to[l] = stored(R(value(l)));
        return;
    }
#pragma GCC ivdep
    for (int l = 0; l < kLanes; ++l) {
        const Stored<R> here = stored(R(value(l)));
        to[l] = (mask >> l & 1) != 0 ? here : to[l];
    }
}

/// The operation R = F(A).
template <class R, class A, auto F>
void unary(Warp& w, const Instruction& i) {
    const auto* a = w.at<Stored<A>>(i.from[0]);
    setLanes<R>(w, i.to[0], [&](int l) { return F(A(a[l])); });
}
/// The operation R = F(A, B).
template <class R, class A, class B, auto F>
void binary(Warp& w, const Instruction& i) {
    const auto* a = w.at<Stored<A>>(i.from[0]);
    const auto* b = w.at<Stored<B>>(i.from[1]);
    setLanes<R>(w, i.to[0], [&](int l) { return F(A(a[l]), B(b[l])); });
}
/// The operation R = F(A, A, C).
template <class R, class A, class C, auto F>
void ternary(Warp& w, const Instruction& i) {
    const auto* a = w.at<Stored<A>>(i.from[0]);
    const auto* b = w.at<Stored<A>>(i.from[1]);
    const auto* c = w.at<Stored<C>>(i.from[2]);
    setLanes<R>(w, i.to[0], [&](int l) { return F(A(a[l]), A(b[l]), C(c[l])); });
}

}  // namespace pdr::ptx
