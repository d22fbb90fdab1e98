#pragma once
/// Ranges that the fields of several files share.

#include "render/scene/field.h"

namespace pdr {

inline constexpr Range kHounsfield{-32768, 32767};
inline constexpr Range kFraction{0, 1};
inline constexpr Range kGradientFactor{0, 1e6};
inline constexpr Range kRadiance{0, 1e30f};  // rounded to float: slightly more than 1e30
inline constexpr Range kPlaceMm{-1e9, 1e9};
inline constexpr Range kExtentMm{0, 1e9, false};
inline constexpr double kLeastMm = 1e-12;  ///< smallest length that is not nothing; its square must not be 0

}  // namespace pdr
