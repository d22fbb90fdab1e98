#pragma once

namespace pdr {

/// The weight of what is seen, as a mask (volume/mask.h) stores it: whole numbers from 0, hidden, up to this. A power
/// of two, so that the fraction is exact.
inline constexpr int kSeen = 4096;

}  // namespace pdr
