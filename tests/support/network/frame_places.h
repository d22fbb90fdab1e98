#pragma once
/// Where fields stand in the header of a frame, for tests that change its bytes (app/wire/frame_header.h).

#include <cstddef>

namespace pdr::test {

inline constexpr std::ptrdiff_t kMapBytesAt = 12, kPayloadBytesAt = 16, kChecksumAt = 24;

}  // namespace pdr::test
