#pragma once
/// Shuffles the bytes of pixel sums or moments so that they compress better. Both are nine words of 8 bytes, little
/// endian; a plane holds one byte of one word of every pixel, in order, padded with zeros to a multiple of 8 bytes.
/// Planes of the lowest bytes of all words come first, then those above: similar bytes, noise or exponents, are
/// neighbours.

#include <cstdint>
#include <span>

#include "render/base/tile.h"
#include "render/film/moments.h"

namespace pdr::wire {

inline constexpr std::size_t kPlanes = sizeof(PixelSums);

/// Returns the size of a plane of that many pixels [bytes].
constexpr std::size_t planeBytes(std::size_t pixels) {
    return (pixels + 7) / 8 * 8;
}

/// Writes the pixels with those indices into kPlanes planes, one behind the other.
template <class Pixel>
void splitPlanes(std::span<const Pixel> pixels, std::span<const std::uint32_t> indices, std::byte* planes);
/// Restores the pixels with those indices from their planes: the inverse of splitPlanes().
template <class Pixel>
void joinPlanes(const std::byte* planes, std::span<const std::uint32_t> indices, std::span<Pixel> pixels);

}  // namespace pdr::wire
