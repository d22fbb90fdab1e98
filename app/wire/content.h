#pragma once
/// Contents: voxels, mask weights and texels, sent from coordinator to node in chunks of kChunkBytes, the last one
/// shorter. A content is addressed by its hash, so that it is sent once, can be resumed and is verified.

#include <span>

#include "app/wire/content_hash.h"
#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

/// Number of chunks of a content.
std::uint32_t chunksOf(std::uint64_t bytes);
/// Chunk `index` of a content. Compressed as one zstd frame: the bytes at even positions, then those at odd ones.
Chunk packChunk(const Hash& content, std::span<const std::byte> bytes, std::uint32_t index);

/// Assembles a content from chunks. Its destructor wipes the memory.
class ContentAssembly {
  public:
    /// Allocates nothing yet.
    ContentAssembly(std::span<const std::byte> key, const Hash& expected, std::uint64_t totalBytes);
    ~ContentAssembly();
    ContentAssembly(ContentAssembly&&) noexcept = default;
    ContentAssembly& operator=(ContentAssembly&&) = delete;

    /// Errors, which change nothing: not the next chunk of this content, damaged, or not enough memory.
    pdr::Result<void> add(const Chunk& chunk);
    /// For Need::from.
    std::uint32_t nextChunk() const;
    bool isWhole() const { return bytes_.size() == totalBytes_; }
    /// Call once, when it is whole. Errors: its hash differs.
    pdr::Result<void> finish();
    const Hash& content() const { return expected_; }
    /// What has arrived so far.
    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    pdr::Result<void> makeRoom();

    Hash expected_;
    std::uint64_t totalBytes_;
    ContentHash hash_;
    Bytes bytes_;
};

}  // namespace pdr::wire
