#pragma once
/// Frames of somebody who means harm and can pack: what is made up is compressed last, so that it reaches what lies
/// behind zstd. Chance makes no sound zstd frame.

#include <cstring>
#include <utility>

#include "app/wire/message_codec.h"
#include "tests/fuzz/heard.h"

namespace pdr::test {

/// What a made-up frame does wrong, a bit each.
enum Wrong : unsigned {
    kOtherOwn = 1,       ///< a count of own pixels that the places do not have
    kOtherPixels = 2,    ///< a slice of a pixel more
    kShort = 4,          ///< a byte less behind zstd than the head asks for
    kLong = 8,           ///< and one more
    kDamaged = 16,       ///< one byte of the packed payload is another one
    kTail = 32,          ///< a byte behind the last slice
    kSliceTooMany = 64,  ///< a slice twice
};

/// Reads made-up bytes from the front; zeros when they are used up.
class MadeUp {
  public:
    explicit MadeUp(std::span<const std::byte> bytes) : bytes_(bytes) {}

    unsigned number() {
        if (bytes_.empty())
            return 0;
        const auto first = std::to_integer<unsigned>(bytes_.front());
        bytes_ = bytes_.subspan(1);
        return first;
    }
    /// Fills `raw` with all that is left, as often as it takes.
    void fill(std::span<std::byte> raw) const {
        if (bytes_.empty()) {
            std::ranges::fill(raw, std::byte(0));
            return;
        }
        for (; !raw.empty(); raw = raw.subspan(std::min(raw.size(), bytes_.size())))
            std::memcpy(raw.data(), bytes_.data(), std::min(raw.size(), bytes_.size()));
    }
    void skip(std::size_t count) { bytes_ = bytes_.subspan(std::min(count, bytes_.size())); }

  private:
    std::span<const std::byte> bytes_;
};

/// Compresses with memory that is kept from frame to frame.
inline wire::Bytes packedAgain(std::span<const std::byte> head, std::span<const std::byte> raw) {
    static wire::FramePacker packer(-1);
    wire::Bytes packed(head.begin(), head.end());
    const auto frame = packer.pack(raw);
    packed.insert(packed.end(), frame.begin(), frame.end());
    return packed;
}

/// A slice of that many pixels (packed_sums.h) whose places and planes are made up; `wrong`: see Wrong.
inline wire::Bytes packedSlice(std::size_t pixels, unsigned wrong, MadeUp& made) {
    const unsigned otherOwn = made.number();
    wire::Bytes places((pixels + 7) / 8);
    made.fill(places);
    made.skip(places.size());
    std::uint32_t own = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        own += std::to_integer<unsigned>(places[pixel / 8] >> pixel % 8) & 1;
    if (wrong & kOtherOwn)
        own = otherOwn;
    wire::Bytes raw(sizeof(PixelSums) + places.size() + wire::kPlanes * wire::planeBytes(own));
    made.fill(raw);
    std::ranges::copy(places, raw.begin() + sizeof(PixelSums));
    if (wrong & kShort)
        raw.pop_back();
    if (wrong & kLong)
        raw.push_back(std::byte(1));
    const std::uint32_t head[2]{std::uint32_t(pixels + (wrong & kOtherPixels ? 1 : 0)), own};
    return packedAgain(std::as_bytes(std::span(head)), raw);
}

/// A frame of `message`, which has no payload yet, with that one.
inline wire::Bytes framed(wire::Message message, const wire::Bytes& payload) {
    wire::Frame frame = wire::encode(std::move(message));
    wire::FrameHeader header{.type = 0};
    std::memcpy(&header.type, &frame.head[6], sizeof header.type);
    header.mapBytes = std::uint32_t(frame.head.size() - wire::kHeaderBytes);
    header.payloadBytes = payload.size();
    std::ranges::copy(wire::bytesOf(header), frame.head.begin());
    frame.payload = payload;
    return wire::inOnePiece(frame);
}

/// Bytes for one side.
struct MadeFrame {
    wire::Role reader;
    wire::Bytes bytes;
};

/// Sums or moments of a tile, behind each other: `slices` of them.
inline wire::Bytes packedSlices(int slices, std::size_t pixels, unsigned wrong, MadeUp& made) {
    wire::Bytes payload;
    for (int i = 0; i < slices; ++i) {
        const wire::Bytes slice = packedSlice(pixels, wrong, made);
        payload.insert(payload.end(), slice.begin(), slice.end());
    }
    return payload;
}

/// Makes up a chunk (kind 0), a lease (1; of several blocks: 2) or a result (3; 4). `bytes`: kind; what is wrong with
/// it; width; height; where it is damaged; then what is compressed.
inline MadeFrame packedFrameOf(std::span<const std::byte> bytes) {
    MadeUp made(bytes);
    const unsigned kind = made.number() % 5, wrong = made.number();
    const Tile tile{0, 0, int(made.number() % 9) + 1, int(made.number() % 9) + 1};
    const unsigned where = made.number();
    const std::size_t pixels = std::size_t(tile.width) * std::size_t(tile.height);
    const bool isDeep = kind == 2 || kind == 4;
    const SampleRange samples = isDeep ? SampleRange{kSamplesPerBlock, 2 * kSamplesPerBlock} : SampleRange{2, 5};
    wire::Bytes payload;
    wire::Message message;
    if (kind == 0) {
        wire::Bytes raw(16 * pixels);
        made.fill(raw);
        payload = packedAgain({}, raw);
        message = wire::Chunk{{}, 0, std::uint32_t(raw.size() + (wrong & kShort ? 1 : 0)), {}};
    } else {
        payload = packedSlices((kind == 4 ? 2 : 1) + (wrong & kSliceTooMany ? 1 : 0), pixels, wrong, made);
        if (kind < 3)
            message = wire::Lease{1, {}, 0, tile, samples, {}, {}};
        else
            message = wire::Result{1, {}, 0, tile, samples, {}, {}, 0, {}};
    }
    if (wrong & kDamaged)
        payload[where * payload.size() / 256] ^= std::byte(1 + where % 255);
    if (wrong & kTail)
        payload.push_back(std::byte(0));
    return {kind < 3 ? wire::Role::node : wire::Role::coordinator, framed(std::move(message), payload)};
}

}  // namespace pdr::test
