#include "app/wire/byte_planes.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

namespace pdr::wire {

namespace {

// Both consist of nine words of 8 bytes without padding.
constexpr std::size_t kWords = 9;
static_assert(sizeof(PixelSums) == kWords * 8 && std::is_trivially_copyable_v<PixelSums>);
static_assert(sizeof(Moments) == kWords * 8 && std::is_trivially_copyable_v<Moments>);
static_assert(std::endian::native == std::endian::little);

/// Swaps the bytes of `high` that `mask` selects with the bytes of `low` that lie `bits` bits above the mask.
void swapBytes(std::uint64_t& low, std::uint64_t& high, int bits, std::uint64_t mask) {
    const std::uint64_t differ = ((low >> bits) ^ high) & mask;
    high ^= differ;
    low ^= differ << bits;
}

/// Transposes an 8 x 8 matrix of bytes: byte b of word w becomes byte w of word b.
void transpose(std::uint64_t (&words)[8]) {
    for (int i = 0; i < 4; ++i)
        swapBytes(words[i], words[i + 4], 32, 0x00000000ffffffff);
    for (int i : {0, 1, 4, 5})
        swapBytes(words[i], words[i + 2], 16, 0x0000ffff0000ffff);
    for (int i : {0, 2, 4, 6})
        swapBytes(words[i], words[i + 1], 8, 0x00ff00ff00ff00ff);
}

/// Calls word(w, first, count) for each word w of each group of eight pixels; a group begins at pixel `first` and has
/// `count` <= 8 pixels. The outer loop runs over the words, so that few planes are written at a time: more of them
/// would evict each other from the cache.
template <class Word>
void eachWord(std::size_t pixels, Word&& word) {
    for (std::size_t w = 0; w < kWords; ++w)
        for (std::size_t first = 0; first < pixels; first += 8)
            word(w, first, std::min<std::size_t>(8, pixels - first));
}

constexpr std::size_t planeOf(std::size_t word, std::size_t b) {
    return kWords * b + word;
}

template <class Pixel>
std::byte* at(Pixel& pixel, std::size_t word) {
    return reinterpret_cast<std::byte*>(&pixel) + 8 * word;
}
template <class Pixel>
const std::byte* at(const Pixel& pixel, std::size_t word) {
    return reinterpret_cast<const std::byte*>(&pixel) + 8 * word;
}

}  // namespace

template <class Pixel>
void splitPlanes(std::span<const Pixel> pixels, std::span<const std::uint32_t> indices, std::byte* planes) {
    const std::size_t stride = planeBytes(indices.size());
    eachWord(indices.size(), [&](std::size_t word, std::size_t first, std::size_t count) {
        std::uint64_t words[8]{};
        for (std::size_t i = 0; i < count; ++i)
            std::memcpy(&words[i], at(pixels[indices[first + i]], word), 8);
        transpose(words);
        for (std::size_t b = 0; b < 8; ++b)
            std::memcpy(planes + planeOf(word, b) * stride + first, &words[b], 8);
    });
}

template <class Pixel>
void joinPlanes(const std::byte* planes, std::span<const std::uint32_t> indices, std::span<Pixel> pixels) {
    const std::size_t stride = planeBytes(indices.size());
    eachWord(indices.size(), [&](std::size_t word, std::size_t first, std::size_t count) {
        std::uint64_t words[8];
        for (std::size_t b = 0; b < 8; ++b)
            std::memcpy(&words[b], planes + planeOf(word, b) * stride + first, 8);
        transpose(words);
        for (std::size_t i = 0; i < count; ++i)
            std::memcpy(at(pixels[indices[first + i]], word), &words[i], 8);
    });
}

template void splitPlanes(std::span<const PixelSums>, std::span<const std::uint32_t>, std::byte*);
template void splitPlanes(std::span<const Moments>, std::span<const std::uint32_t>, std::byte*);
template void joinPlanes(const std::byte*, std::span<const std::uint32_t>, std::span<PixelSums>);
template void joinPlanes(const std::byte*, std::span<const std::uint32_t>, std::span<Moments>);

}  // namespace pdr::wire
