#include "app/wire/content.h"

#include <string.h>

#include <algorithm>
#include <cassert>
#include <new>

#include "app/wire/frame_header.h"
#include "app/wire/one_frame.h"

namespace pdr::wire {

namespace {

constexpr int kLevel = 1;  // compression level of zstd

/// Buffer that its destructor wipes.
class Scratch {
  public:
    explicit Scratch(std::size_t bytes) : bytes_(bytes) {}
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { explicit_bzero(bytes_.data(), bytes_.size()); }
    std::span<std::byte> all() { return bytes_; }

  private:
    Bytes bytes_;
};

}  // namespace

std::uint32_t chunksOf(std::uint64_t bytes) {
    return std::uint32_t((bytes + kChunkBytes - 1) / kChunkBytes);
}

Chunk packChunk(const Hash& content, std::span<const std::byte> bytes, std::uint32_t index) {
    assert(index < chunksOf(bytes.size()));
    const std::size_t begin = std::size_t(index) * kChunkBytes;
    const auto raw = bytes.subspan(begin, std::min<std::size_t>(kChunkBytes, bytes.size() - begin));
    Scratch halves(raw.size());
    splitBytes(raw, halves.all());
    return {content, index, std::uint32_t(raw.size()), packedFrame({}, halves.all(), kLevel)};
}

ContentAssembly::ContentAssembly(std::span<const std::byte> key, const Hash& expected, std::uint64_t totalBytes)
    : expected_(expected), totalBytes_(totalBytes), hash_(key) {}

ContentAssembly::~ContentAssembly() {
    if (!bytes_.empty())
        explicit_bzero(bytes_.data(), bytes_.size());
}

std::uint32_t ContentAssembly::nextChunk() const {
    return chunksOf(bytes_.size());
}

/// Reserves memory for the whole content at once: a buffer that moved to grow would leave copies in freed memory.
/// Reserved memory occupies no pages before it is written to.
pdr::Result<void> ContentAssembly::makeRoom() {
    try {
        bytes_.reserve(totalBytes_);
    } catch (const std::exception&) {
        return Error{phrase("there is too little memory"), std::to_string(totalBytes_ >> 20) + " MiB of a scene", "",
                     ErrorKind::memory};
    }
    return {};
}

pdr::Result<void> ContentAssembly::add(const Chunk& chunk) {
    const std::uint64_t begin = bytes_.size(), rest = totalBytes_ - begin;
    if (chunk.content != expected_ || chunk.index != nextChunk() ||
        chunk.rawBytes != std::min<std::uint64_t>(kChunkBytes, rest) || rest == 0)
        return malformed(phrase("a piece of a scan that was not asked for"), "Chunk");
    if (!isFrameOf(chunk.packed, chunk.rawBytes))
        return malformed(phrase("a damaged piece of a scan"), "Chunk");
    if (auto room = makeRoom(); !room)
        return room;
    Scratch halves(chunk.rawBytes);
    if (!FrameUnpacker().unpack(chunk.packed, halves.all()))
        return malformed(phrase("a damaged piece of a scan"), "Chunk");
    bytes_.resize(begin + chunk.rawBytes);
    const auto part = std::span(bytes_).subspan(begin);
    joinBytes(halves.all(), part);
    hash_.add(part);
    return {};
}

pdr::Result<void> ContentAssembly::finish() {
    if (!isWhole() || hash_.finish() != expected_)
        return malformed(phrase("a scan that is not what it was said to be"));
    return {};
}

}  // namespace pdr::wire
