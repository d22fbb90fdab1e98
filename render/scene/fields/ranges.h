#pragma once
/// Ranges that fields of several files share.

#include "render/scene/field.h"

namespace pdr {

inline constexpr Range kHounsfield{-32768, 32767};
inline constexpr Range kFraction{0, 1};
inline constexpr Range kRadiance{0, 1e30f};  // as float has it: a little more
inline constexpr Range kPlaceMm{-1e9, 1e9};
inline constexpr Range kExtentMm{0, 1e9, false};
inline constexpr double kLeastMm = 1e-12;  ///< less is nothing, and its square must not be

}  // namespace pdr
