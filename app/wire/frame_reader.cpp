#include "app/wire/frame_reader.h"

#include <algorithm>
#include <utility>

namespace pdr::wire {

bool FrameReader::fill(Bytes& part, std::size_t size, std::span<const std::byte>& bytes) {
    const auto come = bytes.first(std::min(bytes.size(), size - part.size()));
    part.reserve(size);
    part.insert(part.end(), come.begin(), come.end());
    bytes = bytes.subspan(come.size());
    return part.size() == size;
}

bool FrameReader::skip(std::span<const std::byte>& bytes) {
    const std::size_t come = std::min<std::uint64_t>(bytes.size(), toSkip_);
    bytes = bytes.subspan(come);
    toSkip_ -= come;
    return toSkip_ == 0;
}

pdr::Result<void> FrameReader::readHeader() {
    const auto header = headerOf(reader_, std::span<const std::byte, kHeaderBytes>(head_));
    if (!header)
        return header.error();
    if (!admitted_ && header->bodyBytes() > limits_.beforeAdmission)
        return malformed(phrase("it is too long from somebody who is not known yet"));
    header_ = *header;
    if (kindOf(header->type) == nullptr)
        toSkip_ = header->bodyBytes();
    return {};
}

/// Reads or skips one message. Nothing: a message of unknown type was skipped, or all bytes are consumed and the
/// message is incomplete.
pdr::Result<std::optional<Message>> FrameReader::readOne(std::span<const std::byte>& bytes) {
    if (!fill(head_, kHeaderBytes, bytes))
        return std::optional<Message>();
    if (!header_)
        if (const auto right = readHeader(); !right)
            return right.error();
    const bool known = kindOf(header_->type) != nullptr;
    const bool whole =
        known ? fill(map_, header_->mapBytes, bytes) && fill(payload_, header_->payloadBytes, bytes) : skip(bytes);
    if (!whole)
        return std::optional<Message>();
    if (known && header_->checksum != 0 && header_->checksum != checksumOf(*header_, map_, payload_))
        return malformed(phrase("a message that was damaged on its way"), kindOf(header_->type)->name);
    head_.clear();
    ++messages_;
    return decode(*std::exchange(header_, {}), std::exchange(map_, {}), std::exchange(payload_, {}));
}

pdr::Result<std::optional<Message>> FrameReader::next(std::span<const std::byte>& bytes) {
    while (!error_ && !bytes.empty()) {
        auto message = readOne(bytes);
        if (!message)
            error_ = message.error();
        else if (*message)
            return message;
    }
    if (error_)
        return *error_;
    return std::optional<Message>();
}

}  // namespace pdr::wire
