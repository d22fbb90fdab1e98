#pragma once
/// Makes messages of the bytes that come over a connection, in whatever pieces they come. Knows no socket. Memory is
/// taken for one message at a time, as its bytes come, and never beyond what its type may have.

#include <optional>
#include <span>

#include "app/wire/frame_header.h"
#include "app/wire/message_codec.h"
#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

struct Limits {
    std::uint64_t beforeAdmission =
        64 << 10;  ///< bytes of a frame behind its header, as long as nobody knows who sends
};

class FrameReader {
  public:
    explicit FrameReader(Role reader, Limits limits = {}) : reader_(reader), limits_(limits) {}

    /// Takes bytes off the front of `bytes` until a message is whole; nothing: all are taken and none is whole. To be
    /// called until then: what is done with a message may admit the next one. Errors: the connection is to end; every
    /// later call says the same.
    pdr::Result<std::optional<Message>> next(std::span<const std::byte>& bytes);

    /// The sender is known, and its messages may be as long as their type allows.
    void setAdmitted(bool admitted) { admitted_ = admitted; }
    /// Whether a message has begun that is not whole.
    bool isInside() const { return !head_.empty(); }
    /// Messages so far that were whole, with those of types that are not known, which next() passes over.
    std::int64_t messages() const { return messages_; }

  private:
    /// Fills `part` up to `size`; false: that would take more bytes than there are.
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
