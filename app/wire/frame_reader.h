#pragma once
/// Decodes messages from a stream of bytes that arrives in pieces of any size. Independent of sockets. Allocates for
/// one message at a time, as its bytes arrive, and never beyond the limit of its type.

#include <optional>
#include <span>

#include "app/wire/frame_header.h"
#include "app/wire/message_codec.h"
#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

struct Limits {
    std::uint64_t beforeAdmission = 64 << 10;  ///< limit on a frame's body before the handshake succeeds [bytes]
};

class FrameReader {
  public:
    explicit FrameReader(Role reader, Limits limits = {}) : reader_(reader), limits_(limits) {}

    /// Consumes bytes from the front of `bytes` until a message is complete. Nothing: all bytes are consumed and no
    /// message is complete; call it until then. Errors: the connection must be closed; every later call returns the
    /// same error.
    pdr::Result<std::optional<Message>> next(std::span<const std::byte>& bytes);

    /// Lifts the limit `beforeAdmission`, after the handshake.
    void setAdmitted(bool admitted) { admitted_ = admitted; }
    /// Whether a message has begun to arrive and is incomplete.
    bool isInside() const { return !head_.empty(); }
    /// Complete messages so far, including those of unknown types, which next() skips.
    std::int64_t messages() const { return messages_; }

  private:
    /// Fills `part` up to `size`; false: more bytes are needed.
    static bool fill(Bytes& part, std::size_t size, std::span<const std::byte>& bytes);
    bool skip(std::span<const std::byte>& bytes);
    pdr::Result<void> readHeader();
    pdr::Result<std::optional<Message>> readOne(std::span<const std::byte>& bytes);

    Role reader_;
    Limits limits_;
    bool admitted_ = false;
    std::optional<FrameHeader> header_;
    std::uint64_t toSkip_ = 0;
    std::int64_t messages_ = 0;
    Bytes head_, map_, payload_;
    std::optional<Error> error_;
};

}  // namespace pdr::wire
