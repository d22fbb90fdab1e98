#include "app/wire/packed_sums.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <memory>

#include "app/wire/byte_planes.h"
#include "app/wire/frame_header.h"
#include "app/wire/one_frame.h"

namespace pdr::wire {

namespace {

static_assert(std::endian::native == std::endian::little);

/// Three times as fast as level 1 and within 3 % of its size: what can be packed in planes is easily found.
constexpr int kLevel = -1;

using Indices = std::vector<std::uint32_t>;

struct Head {
    std::uint32_t pixels = 0, own = 0;
};

/// Where the parts lie in what zstd gets.
struct Layout {
    std::size_t pixels, own;

    static constexpr std::size_t places = sizeof(PixelSums);
    std::size_t planes() const { return places + (pixels + 7) / 8; }
    std::size_t bytes() const { return planes() + kPlanes * planeBytes(own); }
};

/// Whether any byte differs; without a branch, for light and dark take turns in noise.
bool differ(const PixelSums& a, const PixelSums& b) {
    using Words = std::array<std::uint64_t, sizeof(PixelSums) / 8>;
    const auto ofA = std::bit_cast<Words>(a), ofB = std::bit_cast<Words>(b);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < ofA.size(); ++i)
        bits |= ofA[i] ^ ofB[i];
    return bits != 0;
}

PixelSums groundOf(std::span<const PixelSums> sums) {
    constexpr std::array<std::byte, offsetof(PixelSums, evenCount)> kDark{};
    const auto dark = std::ranges::find_if(
        sums, [&](const PixelSums& pixel) { return std::memcmp(&pixel, kDark.data(), kDark.size()) == 0; });
    return dark == sums.end() ? PixelSums{} : *dark;
}

/// What zstd gets, or gives back.
class Raw {
  public:
    explicit Raw(const Layout& layout)
        : layout_(layout), bytes_(std::make_unique_for_overwrite<std::byte[]>(layout.bytes())) {}

    std::span<std::byte> all() const { return {bytes_.get(), layout_.bytes()}; }
    std::span<std::byte> places() const { return {bytes_.get() + layout_.places, bytes_.get() + layout_.planes()}; }
    std::byte* planes() const { return bytes_.get() + layout_.planes(); }

  private:
    Layout layout_;
    std::unique_ptr<std::byte[]> bytes_;
};

Indices thoseUnlike(const PixelSums& ground, std::span<const PixelSums> sums) {
    Indices own(sums.size());
    std::size_t count = 0;
    for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
        own[count] = std::uint32_t(pixel);
        count += differ(sums[pixel], ground);
    }
    own.resize(count);
    return own;
}

Raw laidOut(std::span<const PixelSums> sums, const PixelSums& ground, const Indices& own) {
    Raw raw({sums.size(), own.size()});
    std::memcpy(raw.all().data(), &ground, sizeof ground);
    std::ranges::fill(raw.places(), std::byte(0));
    for (const std::uint32_t pixel : own)
        raw.places()[pixel / 8] |= std::byte(1) << pixel % 8;
    splitPlanes(sums, own, raw.planes());
    return raw;
}

/// The pixels whose bit is set, of those that there are.
Indices placesIn(std::span<const std::byte> bits, std::size_t pixels) {
    Indices own;
    for (std::size_t i = 0; i < bits.size(); ++i)
        for (unsigned rest = std::to_integer<unsigned>(bits[i]); rest != 0; rest &= rest - 1)
            if (const std::size_t pixel = 8 * i + std::size_t(std::countr_zero(rest)); pixel < pixels)
                own.push_back(std::uint32_t(pixel));
    return own;
}

Error noPack() {
    return senseless("sums of pixels that cannot be unpacked");
}

}  // namespace

Bytes packSums(std::span<const PixelSums> sums) {
    if (sums.empty())
        return {};
    const PixelSums ground = groundOf(sums);
    const Indices own = thoseUnlike(ground, sums);
    const Raw raw = laidOut(sums, ground, own);
    const Head head{std::uint32_t(sums.size()), std::uint32_t(own.size())};
    return packedFrame(std::as_bytes(std::span(&head, 1)), raw.all(), kLevel);
}

pdr::Result<std::vector<PixelSums>> unpackSums(std::span<const std::byte> packed, std::size_t pixels) {
    Head head;
    if (pixels == 0 && packed.empty())
        return std::vector<PixelSums>();
    if (packed.size() < sizeof head)
        return noPack();
    std::memcpy(&head, packed.data(), sizeof head);
    if (head.pixels != pixels || head.own > pixels)
        return noPack();
    const std::span<const std::byte> frame = packed.subspan(sizeof head);
    const Layout layout{pixels, head.own};
    if (!isFrameOf(frame, layout.bytes()))
        return noPack();
    const Raw raw(layout);
    if (!unpackFrame(frame, raw.all()))
        return noPack();
    const Indices own = placesIn(raw.places(), pixels);
    if (own.size() != head.own)
        return noPack();
    PixelSums ground;
    std::memcpy(&ground, raw.all().data(), sizeof ground);
    std::vector<PixelSums> sums(pixels, ground);
    joinPlanes(raw.planes(), own, sums);
    return sums;
}

}  // namespace pdr::wire
