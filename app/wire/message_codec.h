#pragma once
/// Encodes messages as frames and decodes them. A frame's map holds the fields (fields.h), its payload the bulk data.

#include <optional>
#include <span>

#include "app/wire/frame_header.h"
#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

/// An encoded message: head and payload, to be sent in this order.
struct Frame {
    Bytes head;     ///< header and map
    Bytes payload;  ///< may be empty

    std::size_t bytes() const { return head.size() + payload.size(); }
};

/// Encodes a message. A chunk's bytes are moved, not copied. Ranges are not checked: the peer refuses values out of
/// range.
Frame encode(Message message);
/// Returns the frame as one sequence of bytes.
Bytes inOnePiece(const Frame& frame);

/// Decodes the body after a header that headerOf() has accepted. Nothing: an unknown type, to be skipped. Errors:
/// malformed input.
pdr::Result<std::optional<Message>> decode(const FrameHeader& header, std::span<const std::byte> map, Bytes payload);

}  // namespace pdr::wire
