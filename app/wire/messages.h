#pragma once
/// The messages between coordinator and render node, as plain values; message_codec.h encodes and decodes them. The
/// coordinator has the scan and the image, and nodes render samples for it. No message has a field for a name, a date
/// or an identifier of a patient.
///   node -> coordinator   Hello, Pong, Need, SceneReady, SceneRefused, Result, Abandoned, Draining, Bye
///   coordinator -> node   Welcome, Refused, Ping, SceneOrder, Chunk, Lease, Forget, Bye
/// Texts are lines of UTF-8 of at most kMostWordBytes, without control characters; longer ones are truncated when
/// encoded.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "render/base/health.h"
#include "render/base/lease_limits.h"
#include "render/base/portable.h"
#include "render/base/text.h"
#include "render/base/tile.h"
#include "render/film/moments.h"

namespace pdr::wire {

using Bytes = std::vector<std::byte>;
/// Address of a content: its BLAKE2b-256 hash, keyed with the coordinator's key (content_hash.h).
using Hash = std::array<std::byte, 32>;
/// Unpredictable number of 128 bits.
using Nonce = std::array<std::byte, 16>;

inline constexpr std::size_t kMostNameBytes = 64, kMostWordBytes = 1024;

/// The range of supported versions of the protocol.
///   1   leases of samples of one block
///   2   also leases of several whole blocks, of which one set of moments comes back
struct Versions {
    std::uint16_t lowest = 1, highest = 2;
    bool operator==(const Versions&) const = default;
};
/// Returns the highest version that both sides support; nothing: there is none.
inline std::optional<std::uint16_t> commonVersion(const Versions& ours, const Versions& theirs) {
    const std::uint16_t highest = ours.highest < theirs.highest ? ours.highest : theirs.highest;
    return highest >= ours.lowest && highest >= theirs.lowest ? std::optional(highest) : std::nullopt;
}

/// The node's first message.
struct Hello {
    Versions versions;
    std::string program;            ///< program and its version: "pdrender-node 0.1.0"; at most kMostNameBytes
    std::string name;               ///< name of the node, for the user: "gpu-07"; at most kMostNameBytes
    Nonce boot{};                   ///< unique for each start of the node
    Hash bits{};                    ///< determinism class: hash of the reference tiles (render/tiles/reference_tiles.h)
    std::string device;             ///< device that renders: "cpu"; at most kMostNameBytes
    std::string details;            ///< details of the device: "16 threads"
    std::uint64_t memoryBytes = 0;  ///< memory for scenes
    /// Pixels whose sums the node keeps after it has sent them; none: it does not understand Lease::kept.
    std::optional<std::uint64_t> keptPixels{};
    bool operator==(const Hello&) const = default;
};

/// Accepts the node, after its Hello.
struct Welcome {
    std::uint16_t version = 1;         ///< version of the protocol from here on
    std::uint32_t heartbeatMs = 1000;  ///< time between two Pings; [100, 60000]
    std::array<std::byte, 32> key{};   ///< key of content hashes; new for each start of the coordinator
    bool operator==(const Welcome&) const = default;
};

/// Rejects the node, instead of a Welcome; the connection is closed.
struct Refused {
    enum class Why : std::uint8_t { version = 1, bits = 2, unwanted = 3 };
    Why why = Why::unwanted;
    Text reason;  ///< reason, for the node's log
    bool operator==(const Refused&) const = default;
};

/// Asks the node for a sign of life.
struct Ping {
    std::uint64_t number = 0;
    bool operator==(const Ping&) const = default;
};
/// The immediate answer to the Ping of that number.
struct Pong {
    std::uint64_t number = 0;
    bool operator==(const Pong&) const = default;
};

/// Describes a volume, whose content is int16 Hounsfield units, x fastest, then y, then z (render/volume/volume.h).
struct VolumeOrder {
    Hash content{};
    ivec3 size{0};                              ///< voxels
    std::array<double, 12> patientFromIndex{};  ///< upper three rows of the matrix, column by column [mm]
    bool operator==(const VolumeOrder&) const = default;
};
/// Describes a mask, whose content is int16 weights (render/volume/mask.h).
struct MaskOrder {
    Hash content{};
    ivec3 voxels{0}, shift{0};
    bool operator==(const MaskOrder&) const = default;
};
/// Describes the labels of the voxels, one byte each in the order of the volume's (render/volume/label_map.h).
struct LabelsOrder {
    Hash content{};
    bool operator==(const LabelsOrder&) const = default;
};
/// Describes an environment map, whose content is float RGB texels (render/scene/environment_image.h).
struct EnvironmentOrder {
    Hash content{};
    ivec2 size{0};  ///< texels
    bool operator==(const EnvironmentOrder&) const = default;
};

inline constexpr std::uint64_t kMostTextBytes = 16 << 20;

/// Sets the scene of all later leases.
struct SceneOrder {
    std::uint64_t revision = 0;
    VolumeOrder volume;
    std::optional<MaskOrder> mask;
    std::optional<EnvironmentOrder> environment;
    std::optional<LabelsOrder> labels;
    std::string text;  ///< scene, as in scene files; at most kMostTextBytes; sent as payload
    bool operator==(const SceneOrder&) const = default;
};

/// Requests the chunks of a content, from number `from` on.
struct Need {
    Hash content{};
    std::uint32_t from = 0;
    bool operator==(const Need&) const = default;
};
/// A part of a content: chunk `index` begins at byte index * kChunkBytes of the content.
struct Chunk {
    Hash content{};
    std::uint32_t index = 0;
    std::uint32_t rawBytes = 0;  ///< uncompressed size; at most kChunkBytes
    Bytes packed;                ///< compressed bytes, see content.h; sent as payload
    bool operator==(const Chunk&) const = default;
};
inline constexpr std::uint32_t kChunkBytes = 4 << 20;

/// Reports that the node has loaded the scene.
struct SceneReady {
    std::uint64_t revision = 0;
    bool operator==(const SceneReady&) const = default;
};
/// Reports that the node cannot render the scene.
struct SceneRefused {
    std::uint64_t revision = 0;
    Text reason;  ///< reason, for the user
    /// Place in the line of coordinators, from 1, if that is the reason: the node takes the scene when it is their
    /// turn, and repeats this message as the line moves.
    std::optional<std::uint32_t> place{};
    bool operator==(const SceneRefused&) const = default;
};

/// First version with leases of several blocks.
inline constexpr std::uint16_t kDeepVersion = 2;

/// Requests samples, within the limits of lease_limits.h. The node answers by a Result or an Abandoned with the same
/// number and nonce.
struct Lease {
    std::uint64_t number = 0;
    Nonce nonce{};
    std::uint64_t revision = 0;  ///< revision of the scene
    Tile tile;
    SampleRange samples;
    std::vector<PixelSums> before;  ///< sums of the block's earlier samples, row by row; empty where there are none;
                                    ///< sent compressed, as payload
    std::vector<Moments> moments;   ///< if deep, instead: moments of all earlier samples; likewise
    /// Hash of the bytes of these sums or moments, which are not sent: the node has sent them itself and kept them. One
    /// that has lost them answers by an Abandoned without a reason.
    std::optional<Hash> kept{};
};

/// Returns the samples of a lease.
struct Result {
    std::uint64_t number = 0;
    Nonce nonce{};
    std::uint64_t revision = 0;
    Tile tile;
    SampleRange samples;           ///< samples of the lease
    std::vector<PixelSums> sums;   ///< sums of the block up to samples.end(), row by row; sent compressed, as payload
    Health health;                 ///< faults of the lease's samples
    double seconds = 0;            ///< time spent on the lease's samples
    std::vector<Moments> moments;  ///< if deep: moments of all samples up to samples.end(), row by row; sent behind the
                                   ///< sums, which have only their `seen` bits then
};

/// Returns a lease that the node does not finish.
struct Abandoned {
    std::uint64_t number = 0;
    Nonce nonce{};
    Text reason;  ///< reason, for the user; empty: the node drains or leaves, or the lease is of another scene
    bool operator==(const Abandoned&) const = default;
};

/// Announces that the node finishes its leases and accepts no new ones.
struct Draining {
    bool operator==(const Draining&) const = default;
};
/// Asks the node to erase all scenes and contents.
struct Forget {
    bool operator==(const Forget&) const = default;
};
/// Ends the connection: the last message.
struct Bye {
    Text reason;
    bool operator==(const Bye&) const = default;
};

/// All messages. The type number in frames is the position in this list, from 1: append new types at the end.
using Message = std::variant<Hello, Welcome, Refused, Ping, Pong, SceneOrder, Need, Chunk, SceneReady, SceneRefused,
                             Lease, Result, Abandoned, Draining, Forget, Bye>;

}  // namespace pdr::wire
