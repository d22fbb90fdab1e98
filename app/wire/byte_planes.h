#pragma once
/// Byte shuffle of pixel sums. A PixelSums is nine words of 8 bytes, little endian; a plane holds one byte of one word
/// of every pixel, in order, padded with zeros to a multiple of 8 bytes. The planes of the lowest bytes of all words
/// come first, then those above: similar bytes, noise or exponents, are neighbours.

#include <cstdint>
#include <span>

#include "render/base/tile.h"

namespace pdr::wire {

inline constexpr std::size_t kPlanes = sizeof(PixelSums);

/// Bytes of a plane of that many pixels.
constexpr std::size_t planeBytes(std::size_t pixels) {
    return (pixels + 7) / 8 * 8;
}

/// Of the pixels with those indices; into kPlanes planes, one behind the other.
void splitPlanes(std::span<const PixelSums> pixels, std::span<const std::uint32_t> indices, std::byte* planes);
/// The inverse.
void joinPlanes(const std::byte* planes, std::span<const std::uint32_t> indices, std::span<PixelSums> pixels);

}  // namespace pdr::wire
