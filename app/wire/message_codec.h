#pragma once
/// Messages as frames and back. The map of a frame holds the fields (fields.h), the payload what is large.

#include <optional>
#include <span>

#include "app/wire/frame_header.h"
#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

/// To be sent one behind the other.
struct Frame {
    Bytes head;     ///< header and map
    Bytes payload;  ///< may be empty

    std::size_t bytes() const { return head.size() + payload.size(); }
};

/// A chunk's bytes are moved, not copied. What is out of its range is not looked at: the other side refuses it.
Frame encode(Message message);
/// The frame as one sequence of bytes.
Bytes inOnePiece(const Frame& frame);

/// What came behind `header`, which headerOf() has let pass. Nothing: a type that is not known, to be skipped. Errors:
/// it is no such message.
pdr::Result<std::optional<Message>> decode(const FrameHeader& header, std::span<const std::byte> map, Bytes payload);

}  // namespace pdr::wire
