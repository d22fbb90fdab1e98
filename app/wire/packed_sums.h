#pragma once
/// Compresses pixel sums, and moments alike, without loss and does not check their values: Film::merge validates them.
/// Pixels are split into consecutive slices of kSlicePixels, the last one shorter, so that the working set stays in the
/// cache. A slice:
///   pixels   u32, little endian
///   own      u32: number of pixels that differ from the ground
///   rest     one zstd frame, of exactly:
///     ground   a pixel, little endian: that of a uniform background; zeros if there is none
///     places   a bit for each pixel, the lowest bit of a byte first: 1 = it differs from the ground
///     planes   byte planes of the pixels that differ (byte_planes.h)
/// Zero pixels take zero bytes.

#include <cstdint>
#include <span>
#include <vector>

#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

inline constexpr std::size_t kSlicePixels = 2048;

/// Returns an upper bound on the compressed size of that many pixels [bytes].
constexpr std::size_t packedSumsBound(std::size_t pixels) {
    const std::size_t raw = sizeof(PixelSums) * (pixels + 8) + pixels / 8 + 1;
    return raw + (raw >> 8) + 128 * (pixels / kSlicePixels + 1);
}

/// Appends the pixels of a tile to `packed`.
void pack(std::span<const PixelSums> pixels, Bytes& packed);
void pack(std::span<const Moments> pixels, Bytes& packed);
/// Unpacks exactly `pixels` pixels at the front of `packed` and removes them from there, without allocating more than
/// these need. Errors: `packed` does not begin with as many pixels.
template <class Pixel>
pdr::Result<std::vector<Pixel>> unpack(std::span<const std::byte>& packed, std::size_t pixels);

Bytes packSums(std::span<const PixelSums> sums);
/// Returns exactly `pixels` sums. Errors: `packed` does not hold the sums of as many pixels.
pdr::Result<std::vector<PixelSums>> unpackSums(std::span<const std::byte> packed, std::size_t pixels);

}  // namespace pdr::wire
