#pragma once
/// How large an image may be.

namespace pdr {

/// Pixels, or texels, that a film or any other image has along a side at most.
inline constexpr int kLongestSide = 16384;

}  // namespace pdr
