#pragma once
/// Rules of PTX for floating point that differ from C++'s.

#include <bit>
#include <type_traits>

#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

/// Single precision has but one NaN as a result, 0x7FFFFFFF.
inline f32 canonical(f32 x) {
    return x == x ? x : std::bit_cast<f32>(0x7FFFFFFFu);
}
inline f64 canonical(f64 x) {
    return x;
}

template <class T>
using BitsOf = std::conditional_t<sizeof(T) == 4, u32, u64>;

/// min: -0 is less than 0, and a number less than NaN.
template <class T>
inline T least(T a, T b) {
    if constexpr (std::is_floating_point_v<T>) {
        const T equal = std::bit_cast<T>(BitsOf<T>(std::bit_cast<BitsOf<T>>(a) | std::bit_cast<BitsOf<T>>(b)));
        const T lesser = a < b ? a : a == b ? equal : b;
        return canonical(a != a ? b : b != b ? a : lesser);
    } else {
        return a < b ? a : b;
    }
}
/// max: 0 is greater than -0, and a number greater than NaN.
template <class T>
inline T most(T a, T b) {
    if constexpr (std::is_floating_point_v<T>) {
        const T equal = std::bit_cast<T>(BitsOf<T>(std::bit_cast<BitsOf<T>>(a) & std::bit_cast<BitsOf<T>>(b)));
        const T greater = a > b ? a : a == b ? equal : b;
        return canonical(a != a ? b : b != b ? a : greater);
    } else {
        return a > b ? a : b;
    }
}

}  // namespace pdr::ptx
