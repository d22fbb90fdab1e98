#include "app/wire/packed_sums.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>

#include "app/wire/byte_planes.h"
#include "app/wire/frame_header.h"
#include "app/wire/one_frame.h"

namespace pdr::wire {

namespace {

static_assert(std::endian::native == std::endian::little);

/// Compression level of zstd: three times as fast as level 1 and within 3 % of its size, since the redundancy of byte
/// planes is easy to find.
constexpr int kLevel = -1;

using Indices = std::vector<std::uint32_t>;

struct Head {
    std::uint32_t pixels = 0, own = 0;
};

/// Offsets of the parts in the bytes that zstd compresses.
struct Layout {
    std::size_t pixels, own;

    static constexpr std::size_t places = sizeof(PixelSums);
    constexpr std::size_t planes() const { return places + (pixels + 7) / 8; }
    constexpr std::size_t bytes() const { return planes() + kPlanes * planeBytes(own); }
};

/// Whether any byte differs. Has no branches, which noise would make unpredictable.
template <class Pixel>
bool differ(const Pixel& a, const Pixel& b) {
    using Words = std::array<std::uint64_t, sizeof(Pixel) / 8>;
    const auto ofA = std::bit_cast<Words>(a), ofB = std::bit_cast<Words>(b);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < ofA.size(); ++i)
        bits |= ofA[i] ^ ofB[i];
    return bits != 0;
}

/// Returns the first pixel that is like its neighbour; zeros if there is none. Only a uniform background, lit or not,
/// makes neighbours the same to the last bit.
template <class Pixel>
Pixel groundOf(std::span<const Pixel> pixels) {
    const auto same = std::ranges::adjacent_find(pixels, std::not_fn(differ<Pixel>));
    return same == pixels.end() ? Pixel{} : *same;
}

constexpr std::size_t kRawBytes = Layout{kSlicePixels, kSlicePixels}.bytes();

/// Packs slices and reuses its memory.
class SlicePacker {
  public:
    SlicePacker() : own_(kSlicePixels), raw_(std::make_unique_for_overwrite<std::byte[]>(kRawBytes)) {}

    /// Appends the packed slice to `packed`.
    template <class Pixel>
    void pack(std::span<const Pixel> slice, Bytes& packed) {
        const Pixel ground = groundOf(slice);
        const std::span<const std::uint32_t> own = thoseUnlike(ground, slice);
        const Layout layout{slice.size(), own.size()};
        std::memcpy(raw_.get(), &ground, sizeof ground);
        const std::span<std::byte> places(raw_.get() + layout.places, raw_.get() + layout.planes());
        std::ranges::fill(places, std::byte(0));
        for (const std::uint32_t pixel : own)
            places[pixel / 8] |= std::byte(1) << pixel % 8;
        splitPlanes(slice, own, raw_.get() + layout.planes());
        const Head head{std::uint32_t(slice.size()), std::uint32_t(own.size())};
        append(packed, std::as_bytes(std::span(&head, 1)));
        append(packed, frames_.pack({raw_.get(), layout.bytes()}));
    }

  private:
    template <class Pixel>
    std::span<const std::uint32_t> thoseUnlike(const Pixel& ground, std::span<const Pixel> slice) {
        std::size_t count = 0;
        for (std::size_t pixel = 0; pixel < slice.size(); ++pixel) {
            own_[count] = std::uint32_t(pixel);
            count += differ(slice[pixel], ground);
        }
        return std::span(own_).first(count);
    }
    static void append(Bytes& packed, std::span<const std::byte> bytes) {
        packed.insert(packed.end(), bytes.begin(), bytes.end());
    }

    Indices own_;
    std::unique_ptr<std::byte[]> raw_;
    FramePacker frames_{kLevel};
};

/// Unpacks slices and reuses its memory.
class SliceUnpacker {
  public:
    SliceUnpacker() : raw_(std::make_unique_for_overwrite<std::byte[]>(kRawBytes)) {}

    /// Unpacks the slice at the front of `packed` and removes it from there. False: `packed` does not begin with a
    /// slice of that many pixels.
    template <class Pixel>
    bool unpack(std::span<const std::byte>& packed, std::span<Pixel> slice) {
        Head head;
        if (packed.size() < sizeof head)
            return false;
        std::memcpy(&head, packed.data(), sizeof head);
        if (head.pixels != slice.size() || head.own > slice.size())
            return false;
        packed = packed.subspan(sizeof head);
        const std::span<const std::byte> frame = packed.first(firstFrameBytes(packed));
        packed = packed.subspan(frame.size());
        const Layout layout{slice.size(), head.own};
        if (!frames_.unpack(frame, {raw_.get(), layout.bytes()}) || !findPlaces(layout))
            return false;
        Pixel ground;
        std::memcpy(&ground, raw_.get(), sizeof ground);
        std::ranges::fill(slice, ground);
        joinPlanes(raw_.get() + layout.planes(), own_, slice);
        return true;
    }

  private:
    /// Collects the pixels whose bit is set. False: their number is not the one in the slice's head.
    bool findPlaces(const Layout& layout) {
        own_.clear();
        for (std::size_t i = 0; layout.places + i < layout.planes(); ++i)
            for (unsigned rest = std::to_integer<unsigned>(raw_[layout.places + i]); rest != 0; rest &= rest - 1)
                if (const std::size_t pixel = 8 * i + std::size_t(std::countr_zero(rest)); pixel < layout.pixels)
                    own_.push_back(std::uint32_t(pixel));
        return own_.size() == layout.own;
    }

    Indices own_;
    std::unique_ptr<std::byte[]> raw_;
    FrameUnpacker frames_;
};

template <class Pixel>
void packAll(std::span<const Pixel> pixels, Bytes& packed) {
    if (pixels.empty())
        return;
    packed.reserve(packed.size() + packedSumsBound(pixels.size()));
    SlicePacker packer;
    for (std::size_t first = 0; first < pixels.size(); first += kSlicePixels)
        packer.pack(pixels.subspan(first, std::min(kSlicePixels, pixels.size() - first)), packed);
}

}  // namespace

void pack(std::span<const PixelSums> pixels, Bytes& packed) {
    packAll(pixels, packed);
}

void pack(std::span<const Moments> pixels, Bytes& packed) {
    packAll(pixels, packed);
}

template <class Pixel>
pdr::Result<std::vector<Pixel>> unpack(std::span<const std::byte>& packed, std::size_t count) {
    std::vector<Pixel> pixels;
    if (count == 0)
        return pixels;
    pixels.reserve(count);
    SliceUnpacker unpacker;
    for (std::size_t first = 0; first < count; first += kSlicePixels) {
        pixels.resize(std::min(first + kSlicePixels, count));
        if (!unpacker.unpack(packed, std::span(pixels).subspan(first)))
            return malformed(phrase("sums of pixels that cannot be unpacked"));
    }
    return pixels;
}
template pdr::Result<std::vector<PixelSums>> unpack(std::span<const std::byte>&, std::size_t);
template pdr::Result<std::vector<Moments>> unpack(std::span<const std::byte>&, std::size_t);

Bytes packSums(std::span<const PixelSums> sums) {
    Bytes packed;
    pack(sums, packed);
    return packed;
}

pdr::Result<std::vector<PixelSums>> unpackSums(std::span<const std::byte> packed, std::size_t pixels) {
    auto sums = unpack<PixelSums>(packed, pixels);
    if (sums && !packed.empty())
        return malformed(phrase("sums of pixels that cannot be unpacked"));
    return sums;
}

}  // namespace pdr::wire
