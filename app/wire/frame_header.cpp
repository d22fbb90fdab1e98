#include "app/wire/frame_header.h"

#include <zlib.h>

#include <bit>
#include <cstring>

#include "app/wire/packed_sums.h"

namespace pdr::wire {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::array<char, 4> kMagic{'P', 'D', 'R', '1'};
constexpr std::uint64_t kMostPackedChunk = kChunkBytes + (kChunkBytes >> 8) + 64;  // zstd's upper bound
constexpr std::uint64_t kMostPackedSums = 2 * packedSumsBound(kMostDeepPixels);    // sums and moments
static_assert(packedSumsBound(kMostLeasePixels) <= kMostPackedSums);
static_assert(kMostPackedSums <= kMostPayloadBytes && kMostTextBytes <= kMostPayloadBytes);

// Message types in the order of the variant Message.
constexpr MessageKind kKinds[]{
    {"Hello", true, false, 0},
    {"Welcome", false, true, 0},
    {"Refused", false, true, 0},
    {"Ping", false, true, 0},
    {"Pong", true, false, 0},
    {"SceneOrder", false, true, kMostTextBytes},
    {"Need", true, false, 0},
    {"Chunk", false, true, kMostPackedChunk},
    {"SceneReady", true, false, 0},
    {"SceneRefused", true, false, 0},
    {"Lease", false, true, kMostPackedSums},
    {"Result", true, false, kMostPackedSums},
    {"Abandoned", true, false, 0},
    {"Draining", true, false, 0},
    {"Forget", false, true, 0},
    {"Bye", true, true, 0},
};
static_assert(std::size(kKinds) == std::variant_size_v<Message>);

/// Calls `at(value)` for each field in the order of the layout, to write or to read it.
template <class Header, class At>
void eachField(Header& header, At&& at) {
    at(header.version);
    at(header.type);
    at(header.flags);
    at(header.mapBytes);
    at(header.payloadBytes);
    at(header.checksum);
}

}  // namespace

const MessageKind* kindOf(std::uint16_t type) {
    return type >= 1 && type <= std::size(kKinds) ? &kKinds[type - 1] : nullptr;
}

Error malformed(const Text& reason, std::string_view where) {
    return {phrase("the other side sent what makes no sense: %1", reason), std::string(where),
            phrase("Both programs should be of the same release."), ErrorKind::refused};
}

std::array<std::byte, kHeaderBytes> bytesOf(const FrameHeader& header) {
    std::array<std::byte, kHeaderBytes> bytes;
    std::memcpy(bytes.data(), kMagic.data(), kMagic.size());
    std::size_t place = kMagic.size();
    eachField(header, [&](const auto& value) {
        std::memcpy(bytes.data() + place, &value, sizeof value);
        place += sizeof value;
    });
    return bytes;
}

pdr::Result<FrameHeader> headerOf(Role reader, std::span<const std::byte, kHeaderBytes> bytes) {
    if (std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0)
        return malformed(phrase("it is no message of PD-Render's"));
    FrameHeader header;
    std::size_t place = kMagic.size();
    eachField(header, [&](auto& value) {
        std::memcpy(&value, bytes.data() + place, sizeof value);
        place += sizeof value;
    });
    if (header.version != kLayoutVersion || header.flags != 0)
        return malformed(phrase("its messages are laid out in another way"));
    const MessageKind* kind = kindOf(header.type);
    if (kind == nullptr && header.type >= kFirstCritical)
        return malformed(phrase("a message of a kind that must be understood, but is not known here"));
    if (kind != nullptr && !(reader == Role::node ? kind->fromCoordinator : kind->fromNode))
        return malformed(phrase("such a message goes the other way"), kind->name);
    if (header.mapBytes > kMostMapBytes || header.payloadBytes > (kind ? kind->mostPayload : kMostPayloadBytes))
        return malformed(phrase("it is longer than such a message is"), kind ? kind->name : "");
    return header;
}

std::uint64_t checksumOf(FrameHeader header, std::span<const std::byte> map, std::span<const std::byte> payload) {
    header.checksum = 0;
    const std::array<std::byte, kHeaderBytes> head = bytesOf(header);
    uLong crc = 0;
    for (const std::span<const std::byte> part : {std::span<const std::byte>(head), map, payload})
        if (!part.empty())
            crc = crc32_z(crc, reinterpret_cast<const Bytef*>(part.data()), part.size());
    return std::uint64_t(1) << 32 | crc;
}

}  // namespace pdr::wire
