#pragma once
/// Lossless compression of pixel sums, whatever they hold: Film::merge validates them. Pixels are split into
/// consecutive slices of kSlicePixels, the last one shorter, so that the working set stays in the cache. A slice:
///   pixels   u32, little endian
///   own      u32: pixels that differ from the ground
///   rest     one zstd frame, of exactly:
///     ground   a PixelSums, little endian: that of a plain background, where there is one
///     places   a bit for each pixel, the lowest bit of a byte first: 1 = it differs from the ground
///     planes   of the pixels that do (byte_planes.h)
/// No pixels are no bytes.

#include <cstdint>
#include <span>
#include <vector>

#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

inline constexpr std::size_t kSlicePixels = 2048;

/// Upper bound on the size for that many pixels [bytes].
constexpr std::size_t packedSumsBound(std::size_t pixels) {
    const std::size_t raw = sizeof(PixelSums) * (pixels + 8) + pixels / 8 + 1;
    return raw + (raw >> 8) + 128 * (pixels / kSlicePixels + 1);
}

Bytes packSums(std::span<const PixelSums> sums);
/// Exactly `pixels` sums, without allocating more than those need. Errors: not the compressed sums of that many pixels.
pdr::Result<std::vector<PixelSums>> unpackSums(std::span<const std::byte> packed, std::size_t pixels);

}  // namespace pdr::wire
