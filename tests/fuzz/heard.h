#pragma once
/// What must hold whatever bytes somebody sends: nothing crashes, and what is taken as a message is one: said again, it
/// is heard as the same, byte by byte.

#include <algorithm>
#include <cstdlib>

#include "app/wire/byte_planes.h"
#include "app/wire/content.h"
#include "app/wire/frame_reader.h"
#include "app/wire/one_frame.h"
#include "app/wire/packed_sums.h"

namespace pdr::test {

inline void require(bool truth) {
    if (!truth)
        std::abort();
}

/// A chunk's bytes reach who puts contents together; what comes out is the same when it is sent again.
inline void assemble(const wire::Chunk& chunk) {
    const auto put = [&](const wire::Chunk& part, const auto& then) {
        wire::ContentAssembly content(chunk.content, chunk.content, chunk.rawBytes);
        require(content.nextChunk() == 0 && content.bytes().empty() && content.content() == chunk.content);
        const bool fits = bool(content.add(part));
        require(fits == content.isWhole());
        (void)content.finish();
        if (fits)
            then(content.bytes());
    };
    put(chunk, [&](std::span<const std::byte> once) {
        put(wire::packChunk(chunk.content, once, 0),
            [&](std::span<const std::byte> twice) { require(std::ranges::equal(once, twice)); });
    });
}

/// Sums as somebody packs them who means harm: a sound zstd frame, of just the size that its head asks for. Chance
/// makes none of these. `bytes`: pixels, u16; own pixels, u16; in how many slices, u8; then what is repeated in the
/// frame.
inline void unpackAnySums(std::span<const std::byte> bytes) {
    if (bytes.size() < 6)
        return;
    const auto word = [&](std::size_t at) {
        return std::to_integer<std::uint32_t>(bytes[at]) | std::to_integer<std::uint32_t>(bytes[at + 1]) << 8;
    };
    const std::uint32_t head[2]{std::uint32_t(word(0) % (wire::kSlicePixels + 2)), word(2)};
    const std::size_t slices = std::to_integer<std::size_t>(bytes[4]) % 3 + 1;
    const auto fill = bytes.subspan(5);
    wire::Bytes raw(sizeof(PixelSums) + (head[0] + 7) / 8 + wire::kPlanes * wire::planeBytes(head[1]));
    for (std::size_t i = 0; i < raw.size(); ++i)
        raw[i] = fill[i % fill.size()];
    const wire::Bytes slice = wire::packedFrame(std::as_bytes(std::span(head)), raw, 1);
    wire::Bytes packed;
    for (std::size_t i = 0; i < slices; ++i)
        packed.insert(packed.end(), slice.begin(), slice.end());
    const std::size_t pixels = slices * head[0];
    const auto sums = wire::unpackSums(packed, pixels);
    if (!sums)
        return;
    require(sums->size() == pixels);
    const auto again = wire::unpackSums(wire::packSums(*sums), pixels);
    require(again && std::ranges::equal(std::as_bytes(std::span(*again)), std::as_bytes(std::span(*sums))));
}

inline void sayAgain(wire::Role reader, const wire::Message& message) {
    const wire::Bytes said = inOnePiece(wire::encode(message));
    wire::FrameReader frames(reader);
    frames.setAdmitted(true);
    std::span<const std::byte> rest(said);
    auto heard = frames.next(rest);
    require(heard && *heard && rest.empty());
    require(inOnePiece(wire::encode(**std::move(heard))) == said);
}

/// Bytes in two pieces, cut where the last of them says; from somebody known, or one time in eight from a stranger.
/// What was heard is said again one time in four, for that takes most of the time.
inline void hearAnything(wire::Role reader, std::span<const std::byte> bytes) {
    wire::FrameReader frames(reader);
    frames.setAdmitted(bytes.size() % 8 != 0);
    const std::size_t cut = bytes.empty() ? 0 : std::size_t(bytes.back()) * bytes.size() / 256;
    for (std::span<const std::byte> piece : {bytes.first(cut), bytes.subspan(cut)})
        for (;;) {
            const auto message = frames.next(piece);
            require(!message || !*message || !frames.isInside());
            if (!message || !*message)
                break;
            if (const auto* chunk = std::get_if<wire::Chunk>(&**message))
                assemble(*chunk);
            if (bytes.size() % 4 == 1)
                sayAgain(reader, **message);
        }
}

}  // namespace pdr::test
