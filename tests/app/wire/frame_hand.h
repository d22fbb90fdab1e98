#pragma once
/// Reads bytes as one side would.

#include "app/wire/frame_reader.h"
#include "tests/app/wire/example_messages.h"
#include "tests/support/network/frame_places.h"

namespace pdr::test {

/// What came of some bytes.
struct Heard {
    std::vector<wire::Message> messages;
    std::string error;  ///< empty: none
};

inline void hear(wire::FrameReader& reader, std::span<const std::byte> bytes, Heard& heard) {
    for (;;) {
        auto message = reader.next(bytes);
        if (!message) {
            heard.error = message.error().text();
            return;
        }
        if (!*message)
            return;
        heard.messages.push_back(**std::move(message));
    }
}

inline Heard heardBy(wire::Role role, std::span<const std::byte> bytes, bool admitted = true) {
    wire::FrameReader reader(role);
    reader.setAdmitted(admitted);
    Heard heard;
    hear(reader, bytes, heard);
    return heard;
}

/// The frame without its checksum, as programs send it that state none: what is changed in it is not found at once.
inline wire::Bytes unchecked(wire::Bytes frame) {
    std::fill_n(frame.begin() + kChecksumAt, sizeof(std::uint64_t), std::byte(0));
    return frame;
}

/// The message on its way to the other side.
inline Heard sent(const wire::Message& message) {
    return heardBy(readerOf(message), wire::inOnePiece(wire::encode(message)));
}

}  // namespace pdr::test
