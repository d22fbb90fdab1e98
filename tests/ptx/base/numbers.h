#pragma once
/// The numbers of PTX, by PTX's own names.

#include <cstddef>
#include <cstdint>

namespace pdr::ptx {

using u8 = std::uint8_t;
using u16 = std::uint16_t;
using u32 = std::uint32_t;
using u64 = std::uint64_t;
using s8 = std::int8_t;
using s16 = std::int16_t;
using s32 = std::int32_t;
using s64 = std::int64_t;
using f32 = float;
using f64 = double;

inline constexpr int kLanes = 32;             ///< threads of a warp
inline constexpr u32 kAllLanes = 0xFFFFFFFF;  ///< as a mask

}  // namespace pdr::ptx
