#pragma once
/// A content is bulk data of a scene: voxels, mask weights or texels. The coordinator sends it to a node in chunks of
/// kChunkBytes, the last one shorter. It is addressed by its hash, so that it is sent once, can be resumed and is
/// verified.

#include <span>

#include "app/wire/content_hash.h"
#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

/// Returns the number of chunks of a content of that many bytes.
std::uint32_t chunksOf(std::uint64_t bytes);
/// Returns chunk `index` of a content, compressed as one zstd frame: the bytes at even positions, then those at odd
/// positions.
Chunk packChunk(const Hash& content, std::span<const std::byte> bytes, std::uint32_t index);

/// Assembles a content from chunks. Its destructor wipes the memory.
class ContentAssembly {
  public:
    /// Allocates nothing yet. `key`: key of the hash; `expected`: hash of the content.
    ContentAssembly(std::span<const std::byte> key, const Hash& expected, std::uint64_t totalBytes);
    ~ContentAssembly();
    ContentAssembly(ContentAssembly&&) noexcept = default;
    ContentAssembly& operator=(ContentAssembly&&) = delete;

    /// Appends the next chunk. Errors, which change nothing: not the next chunk of this content, damaged, or not enough
    /// memory.
    pdr::Result<void> add(const Chunk& chunk);
    /// Returns the index of the next chunk, for Need::from.
    std::uint32_t nextChunk() const;
    bool isWhole() const { return bytes_.size() == totalBytes_; }
    /// Verifies the hash; call it once, when the content is whole. Errors: the hash differs, or the content is not
    /// whole.
    pdr::Result<void> finish();
    const Hash& content() const { return expected_; }
    /// Bytes that have arrived so far.
    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    pdr::Result<void> makeRoom();

    Hash expected_;
    std::uint64_t totalBytes_;
    ContentHash hash_;
    Bytes bytes_;
};

}  // namespace pdr::wire
