#pragma once
/// Limits on the size of images.

namespace pdr {

/// Largest number of pixels or texels along a side of a film or any other image.
inline constexpr int kLongestSide = 16384;

}  // namespace pdr
