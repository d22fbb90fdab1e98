#pragma once
/// The header is the first 32 bytes of a frame, little endian. A CBOR map of `mapBytes` follows, then a payload of
/// `payloadBytes`.
///   magic "PDR1"   version u16   type u16   flags u32   mapBytes u32   payloadBytes u64   checksum u64
/// `version` is that of this layout, not of the fields in the maps (Versions in messages.h). `flags` is reserved and 0.
/// `checksum` is checksumOf() of the frame, or 0 from programs that state none. Readers skip unknown types below
/// kFirstCritical; others are an error.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

/// The two sides of a connection.
enum class Role { coordinator, node };

inline constexpr std::size_t kHeaderBytes = 32;
inline constexpr std::uint16_t kLayoutVersion = 1;
inline constexpr std::uint16_t kFirstCritical = 0x80;
inline constexpr std::uint32_t kMostMapBytes = 64 << 10;
inline constexpr std::uint64_t kMostPayloadBytes = 20 << 20;  ///< limit for messages of all types

struct FrameHeader {
    std::uint16_t version = kLayoutVersion;
    std::uint16_t type = 0;
    std::uint32_t flags = 0;
    std::uint32_t mapBytes = 0;
    std::uint64_t payloadBytes = 0;
    std::uint64_t checksum = 0;

    std::uint64_t bodyBytes() const { return mapBytes + payloadBytes; }
    bool operator==(const FrameHeader&) const = default;
};

/// Properties of a message type.
struct MessageKind {
    std::string_view name;
    bool fromNode, fromCoordinator;
    std::uint64_t mostPayload;  ///< limit on the payload [bytes]
};
/// Returns the properties of the type with that number; null: the type is unknown.
const MessageKind* kindOf(std::uint16_t type);
inline std::uint16_t typeOf(const Message& message) {
    return std::uint16_t(message.index() + 1);
}

std::array<std::byte, kHeaderBytes> bytesOf(const FrameHeader& header);
/// Parses and checks a header. Errors: no frame of this protocol, an unknown critical type, a message that the peer
/// must not send, a body over the limit of its type.
pdr::Result<FrameHeader> headerOf(Role reader, std::span<const std::byte, kHeaderBytes> bytes);

/// Returns 2^32 plus the CRC-32 (ISO 3309) of a frame: its header with a checksum of 0, its map and its payload. Never
/// 0.
std::uint64_t checksumOf(FrameHeader header, std::span<const std::byte> map, std::span<const std::byte> payload);

/// Makes the error for malformed input; `where`: name of the message.
Error malformed(const Text& reason, std::string_view where = "");

}  // namespace pdr::wire
