#pragma once
/// Sums of pixels, packed for the way between programs without losing a bit, whatever they hold: whether they are sums
/// at all is for Film::merge to say. Pixels go in slices of kSlicePixels, the last one shorter, one behind the other:
/// what is at work stays in the processor's cache. A slice:
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

/// No pack of that many pixels is longer [bytes].
constexpr std::size_t packedSumsBound(std::size_t pixels) {
    const std::size_t raw = sizeof(PixelSums) * (pixels + 8) + pixels / 8 + 1;
    return raw + (raw >> 8) + 128 * (pixels / kSlicePixels + 1);
}

Bytes packSums(std::span<const PixelSums> sums);
/// Exactly `pixels` sums. No more memory is taken than those need. Errors: it is no pack of so many pixels.
pdr::Result<std::vector<PixelSums>> unpackSums(std::span<const std::byte> packed, std::size_t pixels);

}  // namespace pdr::wire
