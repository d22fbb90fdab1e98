#include "app/wire/message_codec.h"

#include <utility>

#include "app/wire/fields.h"
#include "app/wire/map_reader.h"
#include "app/wire/map_writer.h"
#include "app/wire/payload.h"

namespace pdr::wire {

namespace {

/// Returns an empty message of the type at index `wanted` of the variant.
template <std::size_t... index>
Message emptyMessage(std::size_t wanted, std::index_sequence<index...>) {
    Message message;
    ((wanted == index ? (void)message.emplace<index>() : void()), ...);
    return message;
}

Message emptyMessage(std::uint16_t type) {
    return emptyMessage(type - 1, std::make_index_sequence<std::variant_size_v<Message>>());
}

}  // namespace

Frame encode(Message message) {
    Frame frame;
    MapWriter writer;
    std::visit(
        [&](auto& of) {
            fields(writer, of);
            frame.payload = takePayload(of);
        },
        message);
    const Bytes map = writer.finish();
    FrameHeader header{
        .type = typeOf(message), .mapBytes = std::uint32_t(map.size()), .payloadBytes = frame.payload.size()};
    header.checksum = checksumOf(header, map, frame.payload);
    const auto head = bytesOf(header);
    frame.head.reserve(head.size() + map.size());
    frame.head.assign(head.begin(), head.end());
    frame.head.insert(frame.head.end(), map.begin(), map.end());
    return frame;
}

Bytes inOnePiece(const Frame& frame) {
    Bytes bytes = frame.head;
    bytes.insert(bytes.end(), frame.payload.begin(), frame.payload.end());
    return bytes;
}

pdr::Result<std::optional<Message>> decode(const FrameHeader& header, std::span<const std::byte> map, Bytes payload) {
    const MessageKind* kind = kindOf(header.type);
    if (kind == nullptr)
        return std::optional<Message>();
    Message message = emptyMessage(header.type);
    MapReader reader(map);
    const char* wrong = std::visit(
        [&](auto& of) {
            fields(reader, of);
            const char* wrong = reader.finish();
            return wrong != nullptr ? wrong : givePayload(of, std::move(payload));
        },
        message);
    if (wrong != nullptr)
        return malformed(wrong, kind->name);
    return std::optional(std::move(message));
}

}  // namespace pdr::wire
