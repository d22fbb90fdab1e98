#pragma once
/// Contents: the voxels, weights and texels that scenes are of, on their way from coordinator to node in chunks of
/// kChunkBytes, the last one shorter. A content is named by its hash, so that it is sent once, goes on where it was cut
/// off, and is never another one.

#include <span>

#include "app/wire/content_hash.h"
#include "app/wire/messages.h"
#include "render/base/result.h"

namespace pdr::wire {

/// Chunks of a content of so many bytes.
std::uint32_t chunksOf(std::uint64_t bytes);
/// Chunk `index` of the content `bytes`, of that hash. Packed: as one zstd frame, the bytes at even places, then those
/// at odd ones.
Chunk packChunk(const Hash& content, std::span<const std::byte> bytes, std::uint32_t index);

/// A content that comes chunk by chunk. Its memory, a patient's, is wiped when it goes.
class ContentAssembly {
  public:
    /// Takes no memory yet.
    ContentAssembly(std::span<const std::byte> key, const Hash& expected, std::uint64_t totalBytes);
    ~ContentAssembly();
    ContentAssembly(ContentAssembly&&) noexcept = default;
    ContentAssembly& operator=(ContentAssembly&&) = delete;

    /// Errors: it is not the next chunk of this content, or damaged, or there is no memory for the
    /// content; all is as before then.
    pdr::Result<void> add(const Chunk& chunk);
    /// The number of the chunk that is wanted next: for Need::from.
    std::uint32_t nextChunk() const;
    bool isWhole() const { return bytes_.size() == totalBytes_; }
    /// To be asked once, when it is whole. Errors: it is not what its hash says.
    pdr::Result<void> finish();
    const Hash& content() const { return expected_; }
    /// What has come so far.
    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    pdr::Result<void> makeRoom();

    Hash expected_;
    std::uint64_t totalBytes_;
    ContentHash hash_;
    Bytes bytes_;
};

}  // namespace pdr::wire
