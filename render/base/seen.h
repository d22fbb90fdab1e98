#pragma once
/// The scale of the visibility weights that masks store.

namespace pdr {

/// Weight of fully visible tissue in a mask (volume/mask.h), which stores whole numbers from 0, hidden, up to this. It
/// is a power of two, so that the fraction is exact.
inline constexpr int kSeen = 4096;

}  // namespace pdr
